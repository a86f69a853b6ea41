// Objects as the scene language writes them: plain values in the space in which they were written.
// The parser makes them, messages and the spool carry them, MakeGeom (geom/make_geom.h) turns them
// into something rays can meet.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "rayshade/common/transform_chain.h"
#include "rayshade/common/vector.h"

namespace rayshade {

using SurfaceId = uint32_t;
using TextureId = uint32_t;
inline constexpr SurfaceId kNoSurface = ~SurfaceId{0};

struct SphereSpec {
  double radius = 1;
  Vector center;
};
struct BoxSpec {
  Vector corner, opposite;
};
struct PlaneSpec {
  Vector point, normal;
};
struct DiscSpec {
  double radius = 1;
  Vector center, normal;
};
struct TriangleSpec {
  Vector point[3];
  bool flip = false;
};  // flip: option -f
struct PhongTriangleSpec {
  Vector point[3], normal[3];
  bool flip = false;
};
struct TriangleUvSpec {
  Vector point[3], normal[3];
  double uv[3][2] = {};
  bool flip = false;
};
struct PolygonSpec {
  std::vector<Vector> points;
  bool flip = false;
};
struct CylinderSpec {
  double radius = 1;
  Vector base, top;
};
struct ConeSpec {
  double base_radius = 1;
  Vector base;
  double top_radius = 0;
  Vector top;
};
struct TorusSpec {
  double swept_radius = 1, tube_radius = 1;
  Vector center, normal;
};
struct BlobSpec {
  struct Ball {
    double strength = 1, radius = 1;
    Vector center;
  };
  double threshold = 0;
  std::vector<Ball> balls;  // as written
};
// size x size altitudes, row by row [rayshade4/2 s.6.12]; shared, since the samples are large and
// never change.
struct HeightfieldSpec {
  std::string file;  // for messages
  int size = 0;
  std::shared_ptr<const std::vector<float>> altitudes;
};
enum class AggregateKind : uint8_t { kList, kGrid, kUnion, kIntersect, kDifference };
constexpr bool IsCsg(AggregateKind kind) { return kind >= AggregateKind::kUnion; }

// An aggregate that is one object as a whole: a CSG node with everything in it, lists and instances
// in it included.
struct PlacedSpec;
struct CompositeSpec {
  AggregateKind kind = AggregateKind::kUnion;
  int counts[3] = {1, 1, 1};                               // of a grid
  std::shared_ptr<const std::vector<PlacedSpec>> members;  // as written; CSG has two
};

using GeomSpec = std::variant<SphereSpec, BoxSpec, PlaneSpec, DiscSpec, TriangleSpec,
                              PhongTriangleSpec, TriangleUvSpec, PolygonSpec, CylinderSpec,
                              ConeSpec, TorusSpec, BlobSpec, HeightfieldSpec, CompositeSpec>;

// What is written around an object: its surface (kNoSurface: none of its own), transformations and
// textures.
struct Attributes {
  SurfaceId surface = kNoSurface;
  TransformChain transforms;
  std::vector<TextureId> textures;  // in the order in which they are applied

  bool plain() const { return transforms.empty() && textures.empty(); }
};

struct PlacedSpec {
  GeomSpec geom;
  Attributes attributes;
};

}  // namespace rayshade
