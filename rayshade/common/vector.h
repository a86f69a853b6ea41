// A vector, or a point, of three doubles. Sums run from left to right ((x + y) + z), as in
// Rayshade, so that results can be compared bit for bit [rayshade4/1 s.0.5].
#pragma once

#include <cmath>

#include "rayshade/common/constants.h"

namespace rayshade {

struct Vector {
  double x = 0, y = 0, z = 0;

  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr bool operator==(const Vector&) const = default;
};

constexpr Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vector operator*(const Vector& a, double s) { return s * a; }

constexpr double Dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

constexpr Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// |x| + |y| + |z|.
inline double SumOfSizes(const Vector& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }

inline double Length(const Vector& a) { return std::sqrt(Dot(a, a)); }

// Makes *a a unit vector and returns its former length. A vector shorter than kEpsilon is left as
// it is and 0 is returned, as in Rayshade [rayshade4/2 s.1].
inline double Normalize(Vector* a) {
  const double length = Length(*a);
  if (length < kEpsilon) return 0;
  a->x /= length;
  a->y /= length;
  a->z /= length;
  return length;
}

inline Vector Normalized(Vector a) {
  Normalize(&a);
  return a;
}

// True for vectors without NaN or infinity.
inline bool IsFinite(const Vector& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace rayshade
