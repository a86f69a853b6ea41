// An affine transformation of row vectors, p' = p M + t, with its inverse [rayshade4/2 s.3].
#pragma once

#include <optional>

#include "rayshade/common/bounds.h"
#include "rayshade/common/vector.h"

namespace rayshade {

struct Matrix {
  double m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  bool operator==(const Matrix&) const = default;
};

Matrix operator*(const Matrix& a, const Matrix& b);  // a first, then b

struct Transform {
  Matrix matrix;       // forward, linear part
  Vector translation;  // forward
  Matrix inverse_matrix;
  Vector inverse_translation;

  bool operator==(const Transform&) const = default;

  Vector Point(const Vector& p) const { return Apply(matrix, p) + translation; }
  Vector Direction(const Vector& d) const { return Apply(matrix, d); }
  Vector InversePoint(const Vector& p) const {
    return Apply(inverse_matrix, p) + inverse_translation;
  }
  Vector InverseDirection(const Vector& d) const { return Apply(inverse_matrix, d); }
  // n (M^-1)^T, not normalised.
  Vector Normal(const Vector& n) const {
    const auto& i = inverse_matrix.m;
    return {n.x * i[0][0] + n.y * i[0][1] + n.z * i[0][2],
            n.x * i[1][0] + n.y * i[1][1] + n.z * i[1][2],
            n.x * i[2][0] + n.y * i[2][1] + n.z * i[2][2]};
  }
  // The box around the image of a box, by interval arithmetic [rayshade4/2 s.2.2].
  Bounds Box(const Bounds& box) const;

  static Vector Apply(const Matrix& a, const Vector& p) {
    return {p.x * a.m[0][0] + p.y * a.m[1][0] + p.z * a.m[2][0],
            p.x * a.m[0][1] + p.y * a.m[1][1] + p.z * a.m[2][1],
            p.x * a.m[0][2] + p.y * a.m[1][2] + p.z * a.m[2][2]};
  }
};

Transform Compose(const Transform& first, const Transform& then);

// The makers return nothing where Rayshade stops: a scale factor smaller than kEpsilon, a
// determinant below 1e-10.
Transform Translate(const Vector& by);
std::optional<Transform> Scale(const Vector& by);
// Right-handed, in degrees, about an axis of any length; an axis shorter than kEpsilon is used as
// it is, and *degenerate_axis is set [rayshade4/2 s.3.2].
std::optional<Transform> Rotate(const Vector& axis, double degrees, bool* degenerate_axis);
std::optional<Transform> FromMatrix(const Matrix& matrix, const Vector& translation);

// Adjugate over determinant; nothing where the determinant is smaller than 1e-10 in size.
std::optional<Matrix> Inverse(const Matrix& matrix);

}  // namespace rayshade
