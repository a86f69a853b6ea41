// One branch per kind; see make_geom.h.
#include "rayshade/geom/make_geom.h"

#include "rayshade/geom/blob.h"
#include "rayshade/geom/box.h"
#include "rayshade/geom/composite.h"
#include "rayshade/geom/cone.h"
#include "rayshade/geom/cylinder.h"
#include "rayshade/geom/disc.h"
#include "rayshade/geom/heightfield.h"
#include "rayshade/geom/phong_triangle.h"
#include "rayshade/geom/plane.h"
#include "rayshade/geom/polygon.h"
#include "rayshade/geom/sphere.h"
#include "rayshade/geom/torus.h"
#include "rayshade/geom/triangle.h"

namespace rayshade {

std::optional<Complaint> CheckGeom(const GeomSpec& spec) {
  return std::visit([](const auto& s) { return Check(s); }, spec);
}

std::unique_ptr<const Geom> MakeGeom(const GeomSpec& spec, const ShutterInterval& shutter) {
  if (const auto* composite = std::get_if<CompositeSpec>(&spec)) {
    return MakeComposite(*composite, shutter);
  }
  return std::visit(
      [](const auto& s) -> std::unique_ptr<const Geom> {
        if constexpr (requires { Make(s); }) return Make(s);
        return nullptr;
      },
      spec);
}

bool IsBounded(const GeomSpec& spec) {
  if (const auto* composite = std::get_if<CompositeSpec>(&spec)) {
    return ReachOf(*composite, {}).has_value();
  }
  return !std::holds_alternative<PlaneSpec>(spec);
}

Bounds BoundsOf(const GeomSpec& spec, const ShutterInterval& shutter) {
  if (const auto* composite = std::get_if<CompositeSpec>(&spec)) {
    return ReachOf(*composite, shutter).value_or(Bounds{});
  }
  return std::visit(
      [](const auto& s) -> Bounds {
        if constexpr (requires { BoxOf(s); }) return BoxOf(s);
        return {};
      },
      spec);
}

bool IsInclusive(const GeomSpec& spec) {
  return std::holds_alternative<DiscSpec>(spec) || std::holds_alternative<TriangleSpec>(spec) ||
         std::holds_alternative<PhongTriangleSpec>(spec) ||
         std::holds_alternative<TriangleUvSpec>(spec) ||
         std::holds_alternative<PolygonSpec>(spec) || std::holds_alternative<CompositeSpec>(spec);
}

}  // namespace rayshade
