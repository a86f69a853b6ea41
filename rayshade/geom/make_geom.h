// From what the language wrote to what rays meet.
#pragma once

#include <memory>
#include <optional>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

// The checks that Rayshade makes when it reads an object [rayshade4/2 s.6]; nothing where all is
// well. Numbers that are NaN or infinite are refused with the kind's "Degenerate …" text.
std::optional<Complaint> CheckGeom(const GeomSpec& spec);

// REQUIRES: CheckGeom(spec) did not drop it. Attributes of members inside a composite are kept by
// shared pointer. shutter: for the bounds of composites with animated members.
std::unique_ptr<const Geom> MakeGeom(const GeomSpec& spec, const ShutterInterval& shutter = {});

// Bounds of the object that spec describes, and whether it has any, without building it (for simple
// primitives at the cost of a few comparisons).
bool IsBounded(const GeomSpec& spec);
Bounds BoundsOf(const GeomSpec& spec, const ShutterInterval& shutter = {});
bool IsInclusive(const GeomSpec& spec);

}  // namespace rayshade
