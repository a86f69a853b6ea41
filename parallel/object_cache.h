// Cells of other processes, fetched and kept while there is room: the cache of [RJ s.3, figure 3].
// The cell used longest ago goes first.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "parallel/cell_tree.h"
#include "rayshade/accel/object_set.h"

namespace rayshade::parallel {

class ObjectCache {
 public:
  // limit: bytes that may be kept; 0: no limit. The cell put in last is kept even if it alone
  // exceeds the limit.
  explicit ObjectCache(uint64_t limit) : limit_(limit) {}

  // Null where the cell is not here. Counts as a use.
  const ObjectSet* Find(CellId cell);
  bool Holds(CellId cell) const { return cells_.contains(cell); }
  // Takes a cell in, and drops others until the limit is kept. REQUIRES: not Holds(cell).
  void Put(CellId cell, std::unique_ptr<ObjectSet> objects);

  uint64_t bytes() const { return bytes_; }

 private:
  struct Entry {
    std::unique_ptr<ObjectSet> objects;
    uint64_t bytes;
    uint64_t used;
  };
  uint64_t limit_;
  uint64_t bytes_ = 0;
  uint64_t uses_ = 0;
  std::map<CellId, Entry> cells_;
  std::map<uint64_t, CellId> by_use_;  // `used` of every entry, oldest first
};

}  // namespace rayshade::parallel
