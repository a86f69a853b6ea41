// The cone, pointed or truncated, without caps [rayshade4/2 s.6.10]. Equal radii make a cylinder.
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const ConeSpec& spec);
Bounds BoxOf(const ConeSpec& spec);
std::unique_ptr<const Geom> Make(const ConeSpec& spec);

}  // namespace rayshade
