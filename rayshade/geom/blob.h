// The blob: a surface of equal strength in the joint field of balls [rayshade4/2 s.6.11].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

std::optional<Complaint> Check(const BlobSpec& spec);
Bounds BoxOf(const BlobSpec& spec);
std::unique_ptr<const Geom> Make(const BlobSpec& spec);

}  // namespace rayshade
