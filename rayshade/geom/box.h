// The box with faces along the axes [rayshade4/2 s.6.2].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const BoxSpec& spec);
Bounds BoxOf(const BoxSpec& spec);
std::unique_ptr<const Geom> Make(const BoxSpec& spec);

}  // namespace rayshade
