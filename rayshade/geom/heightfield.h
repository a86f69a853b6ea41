// The height field: a square of altitudes over the unit square [rayshade4/2 s.6.12].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const HeightfieldSpec& spec);
Bounds BoxOf(const HeightfieldSpec& spec);
std::unique_ptr<const Geom> Make(const HeightfieldSpec& spec);

}  // namespace rayshade
