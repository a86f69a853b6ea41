// The torus [rayshade4/2 s.6.13].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const TorusSpec& spec);
Bounds BoxOf(const TorusSpec& spec);
std::unique_ptr<const Geom> Make(const TorusSpec& spec);

}  // namespace rayshade
