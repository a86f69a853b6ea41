// Intersections in double precision, this renderer's and the textbooks', beside the truth.
#pragma once

#include <string>

#include "tests/stability/subjects.h"

namespace rayshade::stability {

// Of a number of rays at one object. Lengths are in units of the object's size.
struct Errors {
  int wrong = 0;         // rays that hit where they should not, or the other way round
  int wrong_counts = 0;  // rays for which the number of crossings is not right
  int misplaced = 0;     // of the hits on both sides: off by more than 1e-5 along the ray
  double median = 0;     // distance of the hit from the true one, across the surface
  double worst = 0;
};

struct Measurement {
  int rays = 0, hits = 0;  // hits: true ones
  Errors ours, plain;
};

// `rays` rays from `distance` sizes away: from 1 on, towards points around the object, half of them
// passing it by; below, towards points of its surface, from that near. The same rays on every
// machine.
Measurement Measure(const Subject& subject, double size, double distance, int rays);

}  // namespace rayshade::stability
