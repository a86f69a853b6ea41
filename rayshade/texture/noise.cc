// See noise.h.
#include "rayshade/texture/noise.h"

#include <bit>
#include <cmath>
#include <utility>

namespace rayshade {
namespace {

// Cyclic redundancy check "ARC": reflected polynomial 0xA001, initial value 0.
uint16_t CrcStep(uint16_t crc, uint8_t byte) {
  crc ^= byte;
  for (int bit = 0; bit < 8; ++bit) {
    crc = static_cast<uint16_t>((crc & 1) ? (crc >> 1) ^ 0xA001 : crc >> 1);
  }
  return crc;
}

// Of three copies of a number's little-endian bytes.
uint16_t CrcOfThree(double number) {
  const uint64_t bits = std::bit_cast<uint64_t>(number);
  uint16_t crc = 0;
  for (int byte = 0; byte < 24; ++byte) {
    crc = CrcStep(crc, static_cast<uint8_t>(bits >> (8 * (byte % 8))));
  }
  return crc;
}

NoiseTables MakeTables() {
  NoiseTables tables;
  for (size_t i = 0; i < tables.random.size(); ++i) {
    tables.random[i] = CrcOfThree(static_cast<double>(i) * 0.12345) * 2.0 / 65536.0 - 1.0;
  }
  for (size_t i = 0; i < tables.shuffle.size(); ++i) tables.shuffle[i] = static_cast<uint16_t>(i);
  // Shuffled by the 48-bit generator that Rayshade uses, from its seed 1.
  uint64_t state = (uint64_t{1} << 16) | 0x330E;
  for (size_t i = 4095; i >= 1; --i) {
    state = (0x5DEECE66Du * state + 0xBu) & ((uint64_t{1} << 48) - 1);
    std::swap(tables.shuffle[i], tables.shuffle[state >> 36]);
  }
  return tables;
}

// One coordinate's place in the lattice.
struct Axis {
  double x;           // moved far into the positive range
  int64_t cell;       // x truncated
  double weights[2];  // of the near and the far corner
};

Axis Locate(double coordinate) {
  constexpr double kLimit = 2147483647.0;
  Axis axis;
  axis.x = coordinate + 1000000.0;
  if (!(std::abs(axis.x) < kLimit)) {
    axis.x = std::isfinite(axis.x) ? std::fmod(axis.x, 4096.0) : 0.0;
  }
  axis.cell = static_cast<int64_t>(axis.x);
  const double f = axis.x - static_cast<double>(axis.cell);
  axis.weights[1] = f * f * (3.0 - 2.0 * f);
  axis.weights[0] = 1.0 - axis.weights[1];
  return axis;
}

struct Corner {
  int a, b, c;
};

// The noises of the tables' offsets 0, 4, … at one point, summed over the corners in this order.
template <int kCount>
void SumCorners(const Vector& p, const Corner (&order)[8], double (&sums)[kCount]) {
  const NoiseTables& tables = GetNoiseTables();
  const auto& h = tables.shuffle;
  const Axis x = Locate(p.x), y = Locate(p.y), z = Locate(p.z);
  for (const Corner& corner : order) {
    const int64_t i = x.cell + corner.a, j = y.cell + corner.b, k = z.cell + corner.c;
    const double w = x.weights[corner.a] * y.weights[corner.b] * z.weights[corner.c];
    const double dx = x.x - static_cast<double>(i);
    const double dy = y.x - static_cast<double>(j);
    const double dz = z.x - static_cast<double>(k);
    const size_t m = h[h[h[i & 4095] ^ (j & 4095)] ^ (k & 4095)] & 255;
    for (size_t n = 0; n < kCount; ++n) {
      const double* r = &tables.random[m + 4 * n];
      sums[n] += w * (0.5 * r[0] + r[1] * dx + r[2] * dy + r[3] * dz);
    }
  }
}

// Weights below or above these bring a sum to its end, by amplitudes that are too small to count or
// too large to be numbers.
constexpr double kFallingWeight = 0.98, kRisingWeight = 1.2;

}  // namespace

const NoiseTables& GetNoiseTables() {
  static const NoiseTables tables = MakeTables();
  return tables;
}

double Noise(const Vector& p) {
  static constexpr Corner kOrder[8] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  double sums[1] = {};
  SumCorners(p, kOrder, sums);
  return sums[0];
}

Vector DNoise(const Vector& p) {
  static constexpr Corner kOrder[8] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1}};
  double sums[3] = {};
  SumCorners(p, kOrder, sums);
  return {sums[0], sums[1], sums[2]};
}

double Fbm(Vector p, double omega, double lambda, int octaves) {
  double sum = 0, amplitude = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * Noise(p);
    amplitude *= omega;
    if (Spent(amplitude) || Absorbed(i, amplitude, omega, sum)) break;
    p = lambda * p;
  }
  return sum;
}

Vector VectorFbm(Vector p, double omega, double lambda, int octaves) {
  Vector sum;
  double amplitude = 1;
  for (int i = 0; i < octaves; ++i) {
    sum = sum + amplitude * DNoise(p);
    amplitude *= omega;
    if (amplitude < kEpsilon || Spent(amplitude)) break;
    p = lambda * p;
  }
  return sum;
}

double Chaos(const Vector& p, int octaves) { return Fbm(p, 0.5, 2.0, octaves); }

double PAChaos(Vector p, int octaves) {
  double sum = 0, amplitude = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += std::abs(amplitude * Noise(p));
    amplitude *= 0.5;
    if (Spent(amplitude) || Absorbed(i, amplitude, 0.5, sum)) break;
    p = 2.0 * p;
  }
  return sum;
}

bool FitOctaves(double weight, int* octaves) {
  const double size = std::abs(weight);
  if (*octaves <= kOctavesMax || size <= kFallingWeight || size >= kRisingWeight) return false;
  *octaves = kOctavesMax;
  return true;
}

double OmegaOf(double h, double lambda) { return std::pow(lambda, -0.5 * (1.0 + 2.0 * h)); }

double NoiseFraction(double sum, double max) {
  return std::isinf(max) ? 0.5 : (max + sum) * 0.5 / max;
}

}  // namespace rayshade
