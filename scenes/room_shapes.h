// What the furniture of the room is made of: frames to place it in, and shapes that become
// polygons.
//
// Units are metres, z is up. A shape is written at once, in the Rayshade language, as flat polygons
// (faces that would not be flat are cut into triangles) or as the language's own round primitives.
#pragma once

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace room {

struct Vector {
  double x = 0, y = 0, z = 0;
};
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
inline double Dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector Unit(const Vector& v) { return (1 / std::sqrt(Dot(v, v))) * v; }
inline double Radians(double degrees) { return degrees * std::numbers::pi / 180; }

// Where a thing stands and how it is turned: local coordinates to the room's.
struct Frame {
  Vector origin;
  Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  Vector At(const Vector& p) const { return origin + p.x * x + p.y * y + p.z * z; }
  Frame Moved(double dx, double dy, double dz) const { return {At({dx, dy, dz}), x, y, z}; }
  // Counterclockwise about the local z and x axes.
  Frame Turned(double degrees) const {
    const double c = std::cos(Radians(degrees)), s = std::sin(Radians(degrees));
    return {origin, c * x + s * y, c * y - s * x, z};
  }
  Frame Tilted(double degrees) const {
    const double c = std::cos(Radians(degrees)), s = std::sin(Radians(degrees));
    return {origin, x, c * y + s * z, c * z - s * y};
  }
};

// A point of a profile that is turned about the local z axis.
struct ProfilePoint {
  double radius, height;
};

class Drawing {
 public:
  int polygon_count() const { return polygon_count_; }

  // The surface of everything that follows.
  void Use(const char* surface) { std::printf("applysurf %s\n", surface); }

  void Polygon(const Frame& frame, const std::vector<Vector>& points) {
    std::vector<Vector> placed;
    for (const Vector& point : points) placed.push_back(Rounded(frame.At(point)));
    if (TwiceArea(placed) < 2e-5) return;  // the language drops what is smaller
    std::printf("poly");
    for (const Vector& point : placed) Print(point);
    std::printf("\n");
    ++polygon_count_;
  }

  void Sphere(const Frame& frame, double radius, const Vector& centre) {
    std::printf("sphere %g", radius);
    Print(Rounded(frame.At(centre)));
    std::printf("\n");
  }

  void Cylinder(const Frame& frame, double radius, const Vector& from, const Vector& to) {
    std::printf("cylinder %g", radius);
    Print(Rounded(frame.At(from)));
    Print(Rounded(frame.At(to)));
    std::printf("\n");
  }

  void Disc(const Frame& frame, double radius, const Vector& centre, const Vector& normal) {
    std::printf("disc %g", radius);
    Print(Rounded(frame.At(centre)));
    Print(Rounded(frame.At(normal) - frame.origin));
    std::printf("\n");
  }

  // A box of six polygons.
  void Box(const Frame& frame, const Vector& low, const Vector& high) {
    Slab(frame, {{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, low.z,
         high.z);
  }

  // An outline (counterclockwise; z is not looked at) as thick as from `low` to `high`.
  void Slab(const Frame& frame, const std::vector<Vector>& outline, double low, double high) {
    std::vector<Vector> top, bottom;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector& a = outline[i];
      const Vector& b = outline[(i + 1) % outline.size()];
      Polygon(frame, {{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high}});
      top.push_back({a.x, a.y, high});
      bottom.insert(bottom.begin(), {a.x, a.y, low});
    }
    Polygon(frame, top);
    Polygon(frame, bottom);
  }

  // A profile turned about the local z axis.
  void Lathe(const Frame& frame, const std::vector<ProfilePoint>& profile, int sides) {
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
      for (int side = 0; side < sides; ++side) {
        Band(frame, Circle(profile[i], side, sides), Circle(profile[i], side + 1, sides),
             Circle(profile[i + 1], side + 1, sides), Circle(profile[i + 1], side, sides));
      }
    }
  }

  // A round bar along a path, mitred at the bends, closed at both ends.
  void Tube(const Frame& frame, const std::vector<Vector>& path, double radius, int sides) {
    const Vector first = Unit(path[1] - path[0]);
    const Vector helper = std::abs(first.z) < 0.9 ? Vector{0, 0, 1} : Vector{1, 0, 0};
    const Vector u = Unit(Cross(helper, first)), v = Cross(first, u);
    std::vector<Vector> ring;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      ring.push_back(path[0] + radius * std::cos(angle) * u + radius * std::sin(angle) * v);
    }
    Polygon(frame, {ring.rbegin(), ring.rend()});
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const std::vector<Vector> next = NextRing(ring, path, i);
      for (int a = 0; a < sides; ++a) {
        const int b = (a + 1) % sides;
        Band(frame, ring[a], ring[b], next[b], next[a]);
      }
      ring = next;
    }
    Polygon(frame, ring);
  }

  // A cushion: a superellipsoid of these half sizes; `square` near 0 is a box, 1 an ellipsoid.
  void Cushion(const Frame& frame, const Vector& half, double square, int rows, int columns) {
    const auto power = [](double base, double exponent) {
      return std::copysign(std::pow(std::abs(base), exponent), base);
    };
    const auto at = [&](int row, int column) -> Vector {
      const double v = std::numbers::pi * (static_cast<double>(row) / rows - 0.5);
      const double u = 2 * std::numbers::pi * (column + 0.5) / columns;
      const double reach = row == 0 || row == rows ? 0 : power(std::cos(v), square);
      return {half.x * reach * power(std::cos(u), square),
              half.y * reach * power(std::sin(u), square), half.z * power(std::sin(v), square)};
    };
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        Band(frame, at(row, column), at(row, column + 1), at(row + 1, column + 1),
             at(row + 1, column));
      }
    }
  }

 private:
  static Vector Circle(const ProfilePoint& point, int side, int sides) {
    const double angle = 2 * std::numbers::pi * (side % sides) / sides;
    return {point.radius * std::cos(angle), point.radius * std::sin(angle), point.height};
  }

  // The ring at the end of segment i: where its side lines meet the plane that halves the bend.
  static std::vector<Vector> NextRing(const std::vector<Vector>& ring,
                                      const std::vector<Vector>& path, std::size_t i) {
    const Vector along = Unit(path[i + 1] - path[i]);
    const Vector after = i + 2 < path.size() ? Unit(path[i + 2] - path[i + 1]) : along;
    const Vector normal = Unit(along + after);
    std::vector<Vector> next;
    for (const Vector& point : ring) {
      next.push_back(point + (Dot(path[i + 1] - point, normal) / Dot(along, normal)) * along);
    }
    return next;
  }

  // A face of four corners, of which two may be the same.
  void Band(const Frame& frame, const Vector& a, const Vector& b, const Vector& c,
            const Vector& d) {
    const auto same = [](const Vector& p, const Vector& q) { return Dot(p - q, p - q) < 1e-12; };
    if (same(a, b)) {
      Polygon(frame, {a, c, d});
    } else if (same(c, d)) {
      Polygon(frame, {a, b, c});
    } else {
      Polygon(frame, {a, b, c, d});
    }
  }

  // To a tenth of a millimetre: what is written.
  static Vector Rounded(const Vector& v) {
    const auto round = [](double c) { return std::round(c * 1e4) / 1e4 + 0.0; };
    return {round(v.x), round(v.y), round(v.z)};
  }

  static double TwiceArea(const std::vector<Vector>& points) {
    Vector sum;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      sum = sum + Cross(points[i] - points[0], points[i + 1] - points[0]);
    }
    return std::sqrt(Dot(sum, sum));
  }

  static void Print(const Vector& v) { std::printf(" %.6g %.6g %.6g", v.x, v.y, v.z); }

  int polygon_count_ = 0;
};

}  // namespace room
