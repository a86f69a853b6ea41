// The cylinder without caps [rayshade4/2 s.6.9].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const CylinderSpec& spec);
Bounds BoxOf(const CylinderSpec& spec);
std::unique_ptr<const Geom> Make(const CylinderSpec& spec);

}  // namespace rayshade
