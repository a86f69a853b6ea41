// Sign changes of polynomials up to degree four within an interval, found between the zeros of
// their derivatives: no closed formula, hence none of the absolute thresholds of Rayshade's solver
// that tie it to one size and distance [rayshade4/2 s.7, s.12.2].
#pragma once

namespace rayshade {

// c[0] + c[1] x + ... + c[4] x^4.
struct Quartic {
  double c[5] = {};

  double operator()(double x) const {
    return (((c[4] * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0];
  }
};

// The zeros at which the quartic changes its sign in [low, high], ascending. Returns how many (up
// to 4). Zeros are as near as double precision can tell the sign of the polynomial.
int SignChanges(const Quartic& q, double low, double high, double roots[4]);

// The same, for an interval that continues another one: *sign (-1, 1, or 0: not known) is the sign
// so far and becomes the sign at `high`; where the sign at `low` differs, low itself is a root.
int SignChanges(const Quartic& q, double low, double high, int* sign, double roots[5]);

}  // namespace rayshade
