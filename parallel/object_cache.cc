// Least recently used; see object_cache.h.
#include "parallel/object_cache.h"

#include "rayshade/common/check.h"

namespace rayshade::parallel {

const ObjectSet* ObjectCache::Find(CellId cell) {
  const auto it = cells_.find(cell);
  if (it == cells_.end()) return nullptr;
  by_use_.erase(it->second.used);
  it->second.used = ++uses_;
  by_use_.emplace(it->second.used, cell);
  return it->second.objects.get();
}

void ObjectCache::Put(CellId cell, std::unique_ptr<ObjectSet> objects) {
  CHECK(!Holds(cell));
  const uint64_t bytes = objects->bytes();
  while (limit_ != 0 && !cells_.empty() && bytes_ + bytes > limit_) {
    const auto oldest = by_use_.begin();
    bytes_ -= cells_.at(oldest->second).bytes;
    cells_.erase(oldest->second);
    by_use_.erase(oldest);
  }
  cells_.emplace(cell, Entry{std::move(objects), bytes, ++uses_});
  by_use_.emplace(uses_, cell);
  bytes_ += bytes;
}

}  // namespace rayshade::parallel
