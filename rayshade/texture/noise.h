// Rayshade's lattice noise and the sums made of it [rayshade4/3 s.12]. Pure functions; the two
// tables are constants that a formula makes.
//
//   1. Period 4096 in each direction. Defined for all arguments: where Rayshade's conversion to an
//   integer would overflow, the argument is wrapped into the period, and NaN counts as 0.
//   2. A sum over no octaves, or over fewer, is 0.
#pragma once

#include <array>
#include <cstdint>

#include "rayshade/common/vector.h"

namespace rayshade {

// About -0.9 to 1, continuous with its first derivative.
double Noise(const Vector& p);
// Three noises at once; the first is Noise but for rounding. Not a derivative.
Vector DNoise(const Vector& p);

// Sum of omega^i Noise(lambda^i p).
double Fbm(Vector p, double omega, double lambda, int octaves);
// The same with DNoise; ends where the weight falls below kEpsilon.
Vector VectorFbm(Vector p, double omega, double lambda, int octaves);
double Chaos(const Vector& p, int octaves);  // omega 1/2, lambda 2
double PAChaos(Vector p, int octaves);       // of absolute values

// The weight of one octave after the other, from the language's H and lambda.
double OmegaOf(double h, double lambda);
// A sum brought from [-max, max] to [0, 1], not clamped; half where max is infinite.
double NoiseFraction(double sum, double max);

// For tests: the tables as such.
struct NoiseTables {
  std::array<double, 267> random;      // R
  std::array<uint16_t, 4096> shuffle;  // H
};
const NoiseTables& GetNoiseTables();

}  // namespace rayshade
