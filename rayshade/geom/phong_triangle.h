// Triangles with vertex normals, with and without vertex uv [rayshade4/2 s.6.6, s.6.7].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const PhongTriangleSpec& spec);
Bounds BoxOf(const PhongTriangleSpec& spec);
std::unique_ptr<const Geom> Make(const PhongTriangleSpec& spec);

std::optional<Complaint> Check(const TriangleUvSpec& spec);
Bounds BoxOf(const TriangleUvSpec& spec);
std::unique_ptr<const Geom> Make(const TriangleUvSpec& spec);

}  // namespace rayshade
