// Zeros of a quartic: Ferrari's formula in double precision, as textbooks have it, and bracketing
// between the zeros of the derivatives in quadruple precision, as the truth.
#pragma once

#include <vector>

#include "tests/stability/quad.h"

namespace rayshade::stability {

// c[0] + c[1] t + ... + c[4] t^4; ascending, double zeros left out.
std::vector<double> QuarticZeros(const double c[5]);
// Those in (low, high).
std::vector<Quad> QuarticZeros(const Quad c[5], Quad low, Quad high);

}  // namespace rayshade::stability
