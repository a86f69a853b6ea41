// Transformations by adjugates; see transform.h.
#include "rayshade/common/transform.h"

#include <cmath>

namespace rayshade {

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      product.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
    }
  }
  return product;
}

Bounds Transform::Box(const Bounds& box) const {
  Bounds image{translation, translation};
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const double a = matrix.m[i][j] * box.low[i];
      const double b = matrix.m[i][j] * box.high[i];
      image.low[j] += std::min(a, b);
      image.high[j] += std::max(a, b);
    }
  }
  return image;
}

Transform Compose(const Transform& first, const Transform& then) {
  Transform both;
  both.matrix = first.matrix * then.matrix;
  both.translation = Transform::Apply(then.matrix, first.translation) + then.translation;
  both.inverse_matrix = then.inverse_matrix * first.inverse_matrix;
  both.inverse_translation =
      Transform::Apply(first.inverse_matrix, then.inverse_translation) + first.inverse_translation;
  return both;
}

Transform Translate(const Vector& by) {
  Transform t;
  t.translation = by;
  t.inverse_translation = -by;
  return t;
}

std::optional<Transform> Scale(const Vector& by) {
  Transform t;
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(by[i]) >= kEpsilon)) return std::nullopt;
    t.matrix.m[i][i] = by[i];
    t.inverse_matrix.m[i][i] = 1.0 / by[i];
  }
  return t;
}

std::optional<Transform> Rotate(const Vector& axis, double degrees, bool* degenerate_axis) {
  Vector n = axis;
  *degenerate_axis = Normalize(&n) == 0;
  const double angle = degrees * kPi / 180.0;
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix r;
  r.m[0][0] = n.x * n.x + (1 - n.x * n.x) * c;
  r.m[0][1] = n.x * n.y * (1 - c) + n.z * s;
  r.m[0][2] = n.x * n.z * (1 - c) - n.y * s;
  r.m[1][0] = n.x * n.y * (1 - c) - n.z * s;
  r.m[1][1] = n.y * n.y + (1 - n.y * n.y) * c;
  r.m[1][2] = n.y * n.z * (1 - c) + n.x * s;
  r.m[2][0] = n.x * n.z * (1 - c) + n.y * s;
  r.m[2][1] = n.y * n.z * (1 - c) - n.x * s;
  r.m[2][2] = n.z * n.z + (1 - n.z * n.z) * c;
  return FromMatrix(r, {});
}

std::optional<Matrix> Inverse(const Matrix& matrix) {
  const auto& a = matrix.m;
  const double determinant = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
                             a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                             a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  if (!(std::abs(determinant) >= 1e-10)) return std::nullopt;
  Matrix inverse;
  auto& b = inverse.m;
  b[0][0] = (a[1][1] * a[2][2] - a[1][2] * a[2][1]) / determinant;
  b[0][1] = (a[0][1] * a[2][2] - a[0][2] * a[2][1]) / -determinant;
  b[0][2] = (a[0][1] * a[1][2] - a[0][2] * a[1][1]) / determinant;
  b[1][0] = (a[1][0] * a[2][2] - a[1][2] * a[2][0]) / -determinant;
  b[1][1] = (a[0][0] * a[2][2] - a[0][2] * a[2][0]) / determinant;
  b[1][2] = (a[0][0] * a[1][2] - a[0][2] * a[1][0]) / -determinant;
  b[2][0] = (a[1][0] * a[2][1] - a[1][1] * a[2][0]) / determinant;
  b[2][1] = (a[0][0] * a[2][1] - a[0][1] * a[2][0]) / -determinant;
  b[2][2] = (a[0][0] * a[1][1] - a[0][1] * a[1][0]) / determinant;
  return inverse;
}

std::optional<Transform> FromMatrix(const Matrix& matrix, const Vector& translation) {
  const std::optional<Matrix> inverse = Inverse(matrix);
  if (!inverse) return std::nullopt;
  Transform t;
  t.matrix = matrix;
  t.translation = translation;
  t.inverse_matrix = *inverse;
  t.inverse_translation = -Transform::Apply(*inverse, translation);
  return t;
}

}  // namespace rayshade
