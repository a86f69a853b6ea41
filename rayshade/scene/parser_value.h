// What a token or a rule of the grammar carries.
#pragma once

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
  operator Vector() const { return {x, y, z}; }
  operator Color() const { return {x, y, z}; }
};

union ParserValue {
  double number;
  int integer;
  NameId name;
  SurfaceId surface;
  NumberValue value;
  Triple triple;
};

}  // namespace rayshade
