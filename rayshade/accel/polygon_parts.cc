// Cutting polygons; see polygon_parts.h.
#include "rayshade/accel/polygon_parts.h"

#include <algorithm>

#include "rayshade/accel/quads.h"

namespace rayshade {
namespace {

// The points in the plane, x and y such that the polygon turns to the left as a whole.
std::vector<Vector> Flattened(std::span<const Vector> points, const Vector& normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const int dominant = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  std::vector<Vector> flat;
  for (const Vector& p : points) flat.push_back({p[(dominant + 1) % 3], p[(dominant + 2) % 3], 0});
  double area = 0;
  for (size_t i = 0; i < flat.size(); ++i) {
    const Vector a = flat[i] - flat[0], b = flat[(i + 1) % flat.size()] - flat[0];
    area += a.x * b.y - a.y * b.x;
  }
  if (area < 0) {
    for (Vector& p : flat) std::swap(p.x, p.y);
  }
  return flat;
}

class Cutter {
 public:
  Cutter(std::span<const Vector> points, const Vector& normal) : flat_(Flattened(points, normal)) {
    for (uint32_t i = 0; i < points.size(); ++i) left_.push_back(i);
  }

  // Cuts off one corner after the other; false where none can be cut off.
  bool Cut() {
    while (left_.size() > 3) {
      const size_t ear = BestEar();
      if (ear == left_.size()) return false;
      TakeCorner(ear);
    }
    if (Turn(left_[0], left_[1], left_[2]) < 0) return false;
    TakeCorner(1);
    return true;
  }

  // Neighbours are joined to convex quadrilaterals.
  std::vector<PolygonPart> Parts() const {
    std::vector<PolygonPart> parts;
    std::vector<bool> used(triangles_.size());
    for (size_t i = 0; i < triangles_.size(); ++i) {
      if (used[i]) continue;
      PolygonPart part{{triangles_[i][0], triangles_[i][1], triangles_[i][2], 0}, 3};
      for (size_t k = i + 1; k < triangles_.size() && part.count == 3; ++k) {
        if (!used[k]) used[k] = Join(triangles_[k], &part);
      }
      parts.push_back(part);
    }
    return parts;
  }

 private:
  using Triangle = std::array<uint32_t, 3>;

  // Twice the area of a triangle; positive where it turns to the left.
  double Turn(uint32_t a, uint32_t b, uint32_t c) const {
    const Vector ab = flat_[b] - flat_[a], ac = flat_[c] - flat_[a];
    return ab.x * ac.y - ab.y * ac.x;
  }
  uint32_t At(size_t i) const { return left_[i % left_.size()]; }

  // The corner that turns to the left, contains no other point, and has the shortest diagonal.
  size_t BestEar() const {
    const size_t n = left_.size();
    std::vector<std::pair<double, size_t>> order;
    for (size_t i = 0; i < n; ++i) {
      const uint32_t a = At(i + n - 1), b = At(i), c = At(i + 1);
      const Vector diagonal = flat_[c] - flat_[a];
      if (Turn(a, b, c) >= 0) order.push_back({Dot(diagonal, diagonal), i});
    }
    std::sort(order.begin(), order.end());
    for (const auto& [length, i] : order) {
      if (IsEmpty(At(i + n - 1), At(i), At(i + 1))) return i;
    }
    return n;
  }

  bool IsEmpty(uint32_t a, uint32_t b, uint32_t c) const {
    return std::none_of(left_.begin(), left_.end(), [&](uint32_t p) {
      const Vector& at = flat_[p];
      if (at == flat_[a] || at == flat_[b] || at == flat_[c]) return false;
      return Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0;
    });
  }

  void TakeCorner(size_t i) {
    const Triangle t = {At(i + left_.size() - 1), At(i), At(i + 1)};
    if (Turn(t[0], t[1], t[2]) > 0) triangles_.push_back(t);
    left_.erase(left_.begin() + static_cast<ptrdiff_t>(i));
  }

  bool Join(const Triangle& t, PolygonPart* part) const {
    for (size_t i = 0; i < 3; ++i) {
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t a = part->corner[i], b = part->corner[(i + 1) % 3];
        if (t[k] != b || t[(k + 1) % 3] != a) continue;
        const uint32_t before = part->corner[(i + 2) % 3], across = t[(k + 2) % 3];
        if (!(Turn(before, a, across) > 0 && Turn(across, b, before) > 0)) return false;
        *part = {{a, across, b, before}, 4};
        return true;
      }
    }
    return false;
  }

  std::vector<Vector> flat_;
  std::vector<uint32_t> left_;  // points not cut off yet
  std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<PolygonPart> CutIntoParts(std::span<const Vector> points, const Vector& normal) {
  if (points.size() > 2 * kPartsMost) return {};
  Cutter cutter(points, normal);
  if (!cutter.Cut()) return {};
  std::vector<PolygonPart> parts = cutter.Parts();
  if (parts.size() > kPartsMost) parts.clear();
  return parts;
}

}  // namespace rayshade
