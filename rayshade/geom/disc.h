// The disc [rayshade4/2 s.6.4].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const DiscSpec& spec);
Bounds BoxOf(const DiscSpec& spec);
std::unique_ptr<const Geom> Make(const DiscSpec& spec);

}  // namespace rayshade
