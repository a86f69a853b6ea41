// Kinds of objects as Rayshade's report names them [rayshade4/1 s.11.3]. A kind is a
// GeomSpec::index().
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>
#include <variant>

#include "rayshade/geom/spec.h"

namespace rayshade {

// "heighfield" is what users know. The original had no count of its own for CSG objects, only for
// what is inside of them.
inline constexpr std::string_view kKindNames[] = {
    "sphere",  "box",      "plane", "disc",  "triangle", "triangle",   "triangle",
    "polygon", "cylinder", "cone",  "torus", "blob",     "heighfield", "csg"};
static_assert(std::size(kKindNames) == std::variant_size_v<GeomSpec>);

// One kind for all that share a name.
constexpr size_t ReportedKind(size_t kind) {
  for (size_t first = 0; first < kind; ++first) {
    if (kKindNames[first] == kKindNames[kind]) return first;
  }
  return kind;
}

}  // namespace rayshade
