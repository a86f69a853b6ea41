// Triangles and polygons that stand in place, as the kernels and the rest of the accelerator read
// them.
#pragma once

#include <cstdint>

#include "rayshade/accel/quads.h"
#include "rayshade/accel/trace_view.h"
#include "rayshade/geom/polygon.h"
#include "rayshade/geom/triangle.h"

namespace rayshade {

struct FlatTriangle {
  TriangleShape shape;
  bool flip;
};

struct FlatPolygon {
  PolygonPlane plane;
  uint32_t first_point, point_count;
  bool flip;
  bool planar;                              // but for rounding: its hits lie in its box
  uint32_t first_part = 0, part_count = 0;  // in FlatObjects::parts
};

// Where an object that is not a sphere is held.
struct Item {
  LeafKind kind;  // kTriangleLeaf, kPolygonLeaf or kOtherLeaf
  uint8_t geom;   // GeomSpec::index()
  uint32_t index;
};

// The arrays. A leaf's objects are neighbours in them.
struct FlatObjects {
  const Item* items;  // of all objects but spheres
  const FlatTriangle* triangles;
  const FlatPolygon* polygons;
  const Vector* points;
  const float* quads;  // around all items (quads.h), by leaves
  const float* parts;  // of polygons (polygon_parts.h), as quads, by eights of a polygon
};

}  // namespace rayshade
