// Buckets of neighbouring ranks; see rank_index.h.
#include "parallel/rank_index.h"

#include <algorithm>

namespace rayshade::parallel {

namespace {

constexpr uint32_t kPerBucket = 4;

}  // namespace

RankIndex::RankIndex(const ObjectSet* set) : set_(set) {
  const uint32_t count = static_cast<uint32_t>(set->size());
  Rank last = 0;
  for (uint32_t i = 0; i < count; ++i) last = std::max(last, set->rank_of(i));
  while ((last >> shift_) > count / kPerBucket) ++shift_;

  // Counting sort by bucket.
  begins_.assign((last >> shift_) + 2, 0);
  for (uint32_t i = 0; i < count; ++i) ++begins_[(set->rank_of(i) >> shift_) + 1];
  for (size_t b = 1; b < begins_.size(); ++b) begins_[b] += begins_[b - 1];
  objects_.resize(count);
  std::vector<uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (uint32_t i = 0; i < count; ++i) objects_[next[set->rank_of(i) >> shift_]++] = i;
}

Hit RankIndex::Find(double distance, Rank rank) const {
  const size_t bucket = rank >> shift_;
  if (bucket + 1 >= begins_.size()) return {};
  for (uint32_t k = begins_[bucket]; k < begins_[bucket + 1]; ++k) {
    if (set_->rank_of(objects_[k]) == rank) return {distance, rank, objects_[k], set_};
  }
  return {};
}

}  // namespace rayshade::parallel
