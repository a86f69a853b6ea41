// Arithmetic with 113 digits of binary (compiler-made, slow), and vectors of any scalar: what
// results in double precision are measured against.
#pragma once

#include <cmath>

#include "rayshade/common/vector.h"

namespace rayshade::stability {

using Quad = __float128;

inline double SquareRoot(double x) { return std::sqrt(x); }
// Newton from the hardware's root: each step doubles its 64 digits.
inline Quad SquareRoot(Quad x) {
  if (!(x > 0)) return 0;
  Quad root = std::sqrt(static_cast<long double>(x));
  for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
  return root;
}

template <class T>
T Size(T x) {
  return x < 0 ? -x : x;
}

template <class T>
struct Vec {
  T x{}, y{}, z{};
  T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

template <class T>
Vec<T> To(const Vector& v) {
  return {T(v.x), T(v.y), T(v.z)};
}
template <class T>
Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec<T> operator*(T s, const Vec<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T Dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec<T> Cross(const Vec<T>& a, const Vec<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
Vec<T> Unit(const Vec<T>& a) {
  return (T(1) / SquareRoot(Dot(a, a))) * a;
}

}  // namespace rayshade::stability
