// An aggregate that is one object: a CSG node with everything in it [rayshade4/2 s.9].
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

// The number of operands, and whether every member can be made.
std::optional<Complaint> Check(const CompositeSpec& spec);

// Where hits can be; nothing where that is everywhere.
std::optional<Bounds> ReachOf(const CompositeSpec& spec, const ShutterInterval& shutter);
std::unique_ptr<const Geom> MakeComposite(const CompositeSpec& spec,
                                          const ShutterInterval& shutter);

}  // namespace rayshade
