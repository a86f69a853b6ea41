// What a token or a rule of the grammar carries.
#pragma once

#include <cstddef>
#include <deque>

#include "rayshade/common/color.h"
#include "rayshade/common/expression.h"
#include "rayshade/common/vector.h"
#include "rayshade/geom/spec.h"
#include "rayshade/scene/names.h"

namespace rayshade {

// A number, or where `expression` is set (owned by Symbols, until the item ends) one that varies.
struct NumberValue {
  double number;
  const Expression* expression;
};

struct Triple {
  double x, y, z;
};

// Owned by the parser's context, until the item ends. Values of the grammar are 8 bytes: wider ones
// made the parser's stack half of the time that reading takes.
struct NumberRef {
  const NumberValue* value;
  operator const NumberValue&() const { return *value; }
};
struct TripleRef {
  const Triple* triple;
  operator Vector() const { return {triple->x, triple->y, triple->z}; }
  operator Color() const { return {triple->x, triple->y, triple->z}; }
};

union ParserValue {
  double number;
  int integer;
  NameId name;
  SurfaceId surface;
  NumberRef value;
  TripleRef triple;
};
static_assert(sizeof(ParserValue) == 8);

// Values of one item; their room is used again by the next.
template <typename T>
class ItemValues {
 public:
  const T* Keep(const T& value) {
    if (used_ == values_.size()) values_.emplace_back();
    T& place = values_[used_++];
    place = value;
    return &place;
  }
  void Clear() { used_ = 0; }

 private:
  std::deque<T> values_;
  size_t used_ = 0;
};

}  // namespace rayshade
