// Textbook formulas; see crossings.h.
#include "tests/stability/crossings.h"

#include <algorithm>
#include <type_traits>

#include "tests/stability/polynomial.h"

namespace rayshade::stability {
namespace {

template <class T>
struct Line {
  Vec<T> o, d;
  Vec<T> At(T t) const { return o + t * d; }
};

template <class T>
void AddCrossing(const Line<T>& line, T t, const Vec<T>& normal, Crossings<T>* found) {
  const T square = Dot(normal, normal);
  const T cosine = square > 0 ? Size(Dot(normal, line.d)) / SquareRoot(square) : T(0);
  if (t > 0) found->push_back({t, cosine});
}

// Zeros of a t^2 + 2 b t + c.
template <class T>
std::vector<T> QuadraticZeros(T a, T b, T c) {
  const T discriminant = b * b - a * c;
  if (!(discriminant >= 0) || a == 0) return {};
  const T root = SquareRoot(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

template <class T>
void Meet(const SphereSpec& s, const Line<T>& line, Crossings<T>* found) {
  const Vec<T> o = line.o - To<T>(s.center);
  const T r = T(s.radius);
  for (const T t : QuadraticZeros(Dot(line.d, line.d), Dot(o, line.d), Dot(o, o) - r * r)) {
    AddCrossing(line, t, o + t * line.d, found);
  }
}

template <class T>
void Meet(const BoxSpec& s, const Line<T>& line, Crossings<T>* found) {
  T near = -T(1e300), far = T(1e300);
  int near_axis = 0, far_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    T first = (T(s.corner[axis]) - line.o[axis]) / line.d[axis];
    T second = (T(s.opposite[axis]) - line.o[axis]) / line.d[axis];
    if (first > second) std::swap(first, second);
    if (first > near) near = first, near_axis = axis;
    if (second < far) far = second, far_axis = axis;
  }
  if (!(near <= far)) return;
  const auto face = [](int axis) { return Vec<T>{T(axis == 0), T(axis == 1), T(axis == 2)}; };
  AddCrossing(line, near, face(near_axis), found);
  AddCrossing(line, far, face(far_axis), found);
}

template <class T>
T PlaneDistance(const Vec<T>& point, const Vec<T>& normal, const Line<T>& line) {
  return Dot(normal, point - line.o) / Dot(normal, line.d);
}

template <class T>
void Meet(const PlaneSpec& s, const Line<T>& line, Crossings<T>* found) {
  const Vec<T> n = To<T>(s.normal);
  AddCrossing(line, PlaneDistance(To<T>(s.point), n, line), n, found);
}

template <class T>
void Meet(const DiscSpec& s, const Line<T>& line, Crossings<T>* found) {
  const Vec<T> n = To<T>(s.normal);
  const T t = PlaneDistance(To<T>(s.center), n, line);
  const Vec<T> from = line.At(t) - To<T>(s.center);
  if (Dot(from, from) <= T(s.radius) * T(s.radius)) AddCrossing(line, t, n, found);
}

// Moeller and Trumbore's test [MT97].
template <class T>
void MeetTriangle(const Vec<T>& a, const Vec<T>& b, const Vec<T>& c, const Line<T>& line,
                  Crossings<T>* found) {
  const Vec<T> first = b - a, second = c - a, p = Cross(line.d, second);
  const T determinant = Dot(first, p);
  if (determinant == 0) return;
  const Vec<T> from = line.o - a;
  const T u = Dot(from, p) / determinant;
  const Vec<T> q = Cross(from, first);
  const T v = Dot(line.d, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return;
  AddCrossing(line, Dot(second, q) / determinant, Cross(first, second), found);
}

template <class T>
void Meet(const TriangleSpec& s, const Line<T>& line, Crossings<T>* found) {
  MeetTriangle(To<T>(s.point[0]), To<T>(s.point[1]), To<T>(s.point[2]), line, found);
}
template <class T>
void Meet(const PhongTriangleSpec& s, const Line<T>& line, Crossings<T>* found) {
  MeetTriangle(To<T>(s.point[0]), To<T>(s.point[1]), To<T>(s.point[2]), line, found);
}
template <class T>
void Meet(const TriangleUvSpec& s, const Line<T>& line, Crossings<T>* found) {
  MeetTriangle(To<T>(s.point[0]), To<T>(s.point[1]), To<T>(s.point[2]), line, found);
}

// Crossing number around the hit, in the plane's own projection.
template <class T>
void Meet(const PolygonSpec& s, const Line<T>& line, Crossings<T>* found) {
  const Vec<T> a = To<T>(s.points[0]);
  Vec<T> n{};
  for (size_t i = 0; i < s.points.size(); ++i) {
    n = n + Cross(To<T>(s.points[i]) - a, To<T>(s.points[(i + 1) % s.points.size()]) - a);
  }
  const T t = PlaneDistance(a, n, line);
  const Vec<T> h = line.At(t);
  const T x = Size(n.x), y = Size(n.y), z = Size(n.z);
  const int dominant = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const int u = (dominant + 1) % 3, v = (dominant + 2) % 3;
  bool inside = false;
  for (size_t i = 0; i < s.points.size(); ++i) {
    const Vec<T> p = To<T>(s.points[i]) - h, q = To<T>(s.points[(i + 1) % s.points.size()]) - h;
    if ((p[v] > 0) == (q[v] > 0)) continue;
    if (p[u] + (q[u] - p[u]) * (p[v] / (p[v] - q[v])) > 0) inside = !inside;
  }
  if (inside) AddCrossing(line, t, n, found);
}

// Across the axis, and along it.
template <class T>
struct AxisSystem {
  Vec<T> base, axis;
  T length;
  AxisSystem(const Vector& from, const Vector& to) : base(To<T>(from)) {
    const Vec<T> whole = To<T>(to) - base;
    length = SquareRoot(Dot(whole, whole));
    axis = (T(1) / length) * whole;
  }
  T Along(const Vec<T>& v) const { return Dot(v, axis); }
  Vec<T> Across(const Vec<T>& v) const { return v - Along(v) * axis; }
};

template <class T>
void Meet(const CylinderSpec& s, const Line<T>& line, Crossings<T>* found) {
  const AxisSystem<T> system(s.base, s.top);
  const Vec<T> from = line.o - system.base;
  const Vec<T> o = system.Across(from), d = system.Across(line.d);
  const T r = T(s.radius);
  for (const T t : QuadraticZeros(Dot(d, d), Dot(o, d), Dot(o, o) - r * r)) {
    const T z = system.Along(from) + t * system.Along(line.d);
    if (z >= 0 && z <= system.length) AddCrossing(line, t, o + t * d, found);
  }
}

template <class T>
void Meet(const ConeSpec& s, const Line<T>& line, Crossings<T>* found) {
  const AxisSystem<T> system(s.base, s.top);
  const Vec<T> from = line.o - system.base;
  const Vec<T> o = system.Across(from), d = system.Across(line.d);
  const T growth = (T(s.top_radius) - T(s.base_radius)) / system.length;
  const T z0 = system.Along(from), dz = system.Along(line.d);
  const T r0 = T(s.base_radius) + growth * z0, dr = growth * dz;  // radius along the ray
  for (const T t : QuadraticZeros(Dot(d, d) - dr * dr, Dot(o, d) - r0 * dr, Dot(o, o) - r0 * r0)) {
    const T z = z0 + t * dz;
    if (!(z >= 0 && z <= system.length)) continue;
    const T radius = r0 + t * dr;
    AddCrossing(line, t, o + t * d - (growth * radius) * system.axis, found);
  }
}

template <class T>
void Meet(const TorusSpec& s, const Line<T>& line, Crossings<T>* found) {
  const Vec<T> n = Unit(To<T>(s.normal)), center = To<T>(s.center);
  const T a = T(s.swept_radius) * T(s.swept_radius), b = T(s.tube_radius) * T(s.tube_radius);
  // The truth is found from the point nearest to the centre; the plain way knows no such care.
  Vec<T> o = line.o - center;
  const T dd = Dot(line.d, line.d);
  T shift = 0;
  if constexpr (std::is_same_v<T, Quad>) {
    shift = -Dot(o, line.d) / dd;
    o = o + shift * line.d;
  }
  const T oz = Dot(o, n), dz = Dot(line.d, n), od = Dot(o, line.d), g = Dot(o, o) - a - b;
  const T c[5] = {g * g + 4 * a * (oz * oz - b), 4 * (od * g + 2 * a * oz * dz),
                  2 * (g * dd + 2 * od * od + 2 * a * dz * dz), 4 * od * dd, dd * dd};
  std::vector<T> zeros;
  if constexpr (std::is_same_v<T, Quad>) {
    const T reach = 2 * (T(s.swept_radius) + T(s.tube_radius));
    zeros = QuarticZeros(c, -reach, reach);
  } else {
    zeros = QuarticZeros(c);
  }
  for (const T t : zeros) {
    const Vec<T> p = o + t * line.d, across = p - Dot(p, n) * n;
    const Vec<T> ring = (T(s.swept_radius) / SquareRoot(Dot(across, across))) * across;
    AddCrossing(line, shift + t, p - ring, found);
  }
}

// The part of a ray in which the same balls are felt.
template <class T>
void MeetBlobPiece(const BlobSpec& s, const Line<T>& line, T low, T high, Crossings<T>* found) {
  const T middle = (low + high) / 2;
  // The truth is found from the middle of the piece; the plain way from the ray's own origin.
  const T shift = std::is_same_v<T, Quad> ? middle : T(0);
  T c[5] = {-T(s.threshold), 0, 0, 0, 0};
  const T dd = Dot(line.d, line.d);
  const auto feels = [&](const BlobSpec::Ball& ball) {
    const Vec<T> from = line.At(middle) - To<T>(ball.center);
    return Dot(from, from) < T(ball.radius) * T(ball.radius);
  };
  for (const BlobSpec::Ball& ball : s.balls) {
    if (!feels(ball)) continue;
    const Vec<T> o = line.At(shift) - To<T>(ball.center);
    const T r2 = T(ball.radius) * T(ball.radius), strength = T(ball.strength);
    // strength (1 - (oo + 2 od t + dd t^2) / r2)^2.
    const T k0 = 1 - Dot(o, o) / r2, k1 = -2 * Dot(o, line.d) / r2, k2 = -dd / r2;
    c[0] += strength * k0 * k0;
    c[1] += strength * 2 * k0 * k1;
    c[2] += strength * (k1 * k1 + 2 * k0 * k2);
    c[3] += strength * 2 * k1 * k2;
    c[4] += strength * k2 * k2;
  }
  if (c[4] == 0) return;
  std::vector<T> zeros;
  if constexpr (std::is_same_v<T, Quad>) {
    zeros = QuarticZeros(c, low - shift, high - shift);
  } else {
    for (const T t : QuarticZeros(c)) {
      if (t > low && t < high) zeros.push_back(t);
    }
  }
  for (const T t : zeros) {
    Vec<T> normal{};
    for (const BlobSpec::Ball& ball : s.balls) {
      const Vec<T> from = line.At(shift + t) - To<T>(ball.center);
      const T r2 = T(ball.radius) * T(ball.radius);
      if (feels(ball))
        normal = normal + (T(ball.strength) / r2 * (1 - Dot(from, from) / r2)) * from;
    }
    AddCrossing(line, shift + t, normal, found);
  }
}

template <class T>
void Meet(const BlobSpec& s, const Line<T>& line, Crossings<T>* found) {
  std::vector<T> ends;
  for (const BlobSpec::Ball& ball : s.balls) {
    const Vec<T> o = line.o - To<T>(ball.center);
    const T r = T(ball.radius);
    for (const T t : QuadraticZeros(Dot(line.d, line.d), Dot(o, line.d), Dot(o, o) - r * r)) {
      ends.push_back(t);
    }
  }
  std::sort(ends.begin(), ends.end());
  for (size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i] < ends[i + 1]) MeetBlobPiece(s, line, ends[i], ends[i + 1], found);
  }
}

template <class T>
void Meet(const HeightfieldSpec& s, const Line<T>& line, Crossings<T>* found) {
  const T cells = T(s.size - 1);
  const auto corner = [&](int x, int y) {
    return Vec<T>{T(x) / cells, T(y) / cells,
                  T((*s.altitudes)[static_cast<size_t>(y) * s.size + x])};
  };
  for (int y = 0; y + 1 < s.size; ++y) {
    for (int x = 0; x + 1 < s.size; ++x) {
      const Vec<T> right = corner(x + 1, y), back = corner(x, y + 1);
      MeetTriangle(corner(x, y), right, back, line, found);
      MeetTriangle(right, corner(x + 1, y + 1), back, line, found);
    }
  }
}

template <class T>
void Meet(const CompositeSpec&, const Line<T>&, Crossings<T>*) {}

}  // namespace

template <class T>
Crossings<T> CrossingsOf(const GeomSpec& spec, double scale, const Vector& origin,
                         const Vector& direction) {
  Crossings<T> found;
  const Line<T> line{(T(1) / T(scale)) * To<T>(origin), (T(1) / T(scale)) * To<T>(direction)};
  std::visit([&](const auto& s) { Meet(s, line, &found); }, spec);
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const T length = SquareRoot(Dot(line.d, line.d));
  for (Crossing<T>& crossing : found) crossing.cosine = crossing.cosine / length;
  return found;
}

template Crossings<double> CrossingsOf(const GeomSpec&, double, const Vector&, const Vector&);
template Crossings<Quad> CrossingsOf(const GeomSpec&, double, const Vector&, const Vector&);

}  // namespace rayshade::stability
