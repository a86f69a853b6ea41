// Words of a scene file, each stored once. A word is known by its number: 0, 1, 2 … in order of
// first appearance, so that what is known about it can lie in an array.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace rayshade {

using NameId = uint32_t;

class NameTable {
 public:
  NameTable();

  NameId Intern(std::string_view text);
  const std::string& text(NameId id) const { return names_[id].text; }
  size_t size() const { return names_.size(); }

 private:
  struct Name {
    std::string text;
    uint32_t hash;
  };
  void Grow();

  std::deque<Name> names_;
  std::vector<uint32_t> slots_;  // number + 1, 0: empty; a power of two of them
};

// One T for each name; T{} where nothing was said.
template <typename T>
class NameMap {
 public:
  T& operator[](NameId id) {
    if (id >= values_.size()) values_.resize(id + 1);
    return values_[id];
  }

 private:
  std::vector<T> values_;
};

}  // namespace rayshade
