// Finds an object of a set by its rank, so that a hit that another process has found need not be
// searched for again by tracing its ray. About five bytes an object.
#pragma once

#include <cstdint>
#include <vector>

#include "rayshade/accel/object_set.h"

namespace rayshade::parallel {

class RankIndex {
 public:
  // set: built; must outlive the index.
  explicit RankIndex(const ObjectSet* set);

  // The hit on the object of this rank; set is null where there is no such object.
  Hit Find(double distance, Rank rank) const;
  size_t bytes() const { return (objects_.capacity() + begins_.capacity()) * sizeof(uint32_t); }

 private:
  const ObjectSet* set_;
  int shift_ = 0;                  // a rank's bucket is rank >> shift_
  std::vector<uint32_t> objects_;  // bucket by bucket
  std::vector<uint32_t> begins_;   // of each bucket, and the end
};

}  // namespace rayshade::parallel
