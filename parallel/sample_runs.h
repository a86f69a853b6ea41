// Samples of the picture in messages: each is a token, and neighbours of a row are told together.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "parallel/wire.h"
#include "rayshade/render/camera.h"

namespace rayshade::parallel {

// A sample as the token of its return address, and back: x and y of 24 bits each, the sub-cell of
// 8, and one that tells single samples.
inline uint64_t TokenOf(const Sample& sample) {
  return static_cast<uint64_t>(static_cast<uint32_t>(sample.x) & 0xffffff) |
         static_cast<uint64_t>(static_cast<uint32_t>(sample.y) & 0xffffff) << 24 |
         static_cast<uint64_t>(sample.sub_cell & 0xff) << 48 |
         static_cast<uint64_t>(sample.single) << 56;
}
inline Sample SampleOf(uint64_t token) {
  return {static_cast<int32_t>(token & 0xffffff), static_cast<int32_t>(token >> 24 & 0xffffff),
          static_cast<uint16_t>(token >> 48 & 0xff), (token >> 56 & 1) != 0};
}
// A sample that the picture does not have is a WireError: it came in a message. samples: as in the
// settings.
void CheckSample(const Sample& sample, const Camera& camera, int samples);

// Up to 128 samples from one on along a row of the picture, all of the same sub-cell: the token of
// the first, and in its seven highest bits, which tokens leave free, how many follow.
class SampleRun {
 public:
  static constexpr bool kPacked = true;
  static constexpr uint32_t kMost = 128;

  SampleRun() = default;
  explicit SampleRun(uint64_t first) : word_(first) {}

  uint64_t first() const { return word_ & kToken; }
  uint32_t count() const { return static_cast<uint32_t>(word_ >> kBits) + 1; }
  // Takes a sample in if it is the next one.
  bool Join(uint64_t token) {
    if (token != first() + count() || count() == kMost || (token & 0xffffff) == 0) return false;
    word_ += uint64_t{1} << kBits;
    return true;
  }
  // Takes `count` samples off the beginning. REQUIRES: fewer than there are.
  void Shorten(uint32_t count) { word_ += count - (uint64_t{count} << kBits); }

  template <class A>
  void Fields(A& a) {
    a("word", word_);
  }

 private:
  static constexpr int kBits = 57;  // of a token
  static constexpr uint64_t kToken = (uint64_t{1} << kBits) - 1;
  uint64_t word_ = 0;
};

// Samples in the order in which they were added.
class SampleRuns {
 public:
  SampleRuns() = default;
  SampleRuns(std::initializer_list<uint64_t> tokens) {
    for (const uint64_t token : tokens) Add(token);
  }

  void Add(uint64_t token) {
    ++size_;
    if (runs_.empty() || !runs_.back().Join(token)) runs_.emplace_back(token);
  }
  void Append(const SampleRuns& more) {
    runs_.insert(runs_.end(), more.runs_.begin(), more.runs_.end());
    size_ += more.size_;
  }
  void clear() {
    runs_.clear();
    size_ = 0;
  }
  size_t size() const { return size_; }  // samples
  bool empty() const { return runs_.empty(); }
  const std::vector<SampleRun>& runs() const { return runs_; }
  std::vector<uint64_t> tokens() const;
  size_t capacity_bytes() const { return runs_.capacity() * sizeof(SampleRun); }
  // As CheckSample, for all of them.
  void Check(const Camera& camera, int samples) const;

  template <class A>
  void Fields(A& a) {
    a("runs", runs_);
    if constexpr (A::kReading) {
      size_ = 0;
      for (const SampleRun& run : runs_) size_ += run.count();
    }
  }

 private:
  std::vector<SampleRun> runs_;
  size_t size_ = 0;
};

}  // namespace rayshade::parallel
