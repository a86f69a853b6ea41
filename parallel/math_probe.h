// The mathematical functions of the C library differ in the last bit from processor to processor
// (with and without fused multiply-add), and so would pictures. Processes compare a hash of probe
// values before they begin.
#pragma once

#include <cstdint>

namespace rayshade::parallel {

// Equal in all processes whose pow, exp, log, sin, cos, tan, acos, asin, atan, cbrt and hypot agree
// on a few hundred arguments in the ranges that shading uses.
uint64_t MathProbe();

}  // namespace rayshade::parallel
