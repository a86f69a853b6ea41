// Rayshade's lattice noise and the sums made of it [rayshade4/3 s.12]. Pure functions; the two
// tables are constants that a formula makes.
//
//   1. Period 4096 in each direction. Defined for all arguments: where Rayshade's conversion to an
//   integer would overflow, the argument is wrapped into the period, and NaN counts as 0.
//   2. A sum over no octaves, or over fewer, is 0.
//   3. A sum of any number of octaves ends where further ones cannot change a bit of it. Those
//   whose
//      weights do not fall are limited when they are read (FitOctaves).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "rayshade/common/vector.h"

namespace rayshade {

// No noise is larger: the eight corners' weights are below 5^3, where coordinates were wrapped into
// the negative, and their values below 7.
inline constexpr double kNoiseBound = 1e4;

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

// Does no octave from this amplitude on, and with this weight from one to the next, change a bit of
// the sums? Asked now and then only, since it takes time.
template <class... Sums>
bool Absorbed(int octave, double amplitude, double weight, Sums... sums) {
  if (octave % 32 != 31 || std::abs(weight) > 1) return false;
  const double most = std::abs(amplitude) * kNoiseBound;
  return ((sums + most == sums && sums - most == sums) && ...);
}
// Nothing is left to add, or nothing that is a number.
inline bool Spent(double amplitude) { return amplitude == 0 || !std::isfinite(amplitude); }
// More octaves than this are computed only where weights fall fast enough to end the sum.
inline constexpr int kOctavesMax = 4096;
// Lowers *octaves to kOctavesMax where the sum would not end by itself; true if it did so.
bool FitOctaves(double weight, int* octaves);

// For tests: the tables as such.
struct NoiseTables {
  std::array<double, 267> random;      // R
  std::array<uint16_t, 4096> shuffle;  // H
};
const NoiseTables& GetNoiseTables();

}  // namespace rayshade
