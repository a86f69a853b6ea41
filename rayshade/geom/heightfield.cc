// The height field; see heightfield.h. Each cell of the grid of samples has two triangles; cells
// are walked through in the order of the ray, blocks of 16 x 16 cells that the ray passes above or
// below are skipped at a step.
//
//   1. The samples are shared, not copied; beside them only the altitude range per block is kept.
//   2. Normals are unit vectors at any number of samples, and the least distance is the ray's own:
//      Rayshade loses flat cells from 318 samples on and uses 1e-5 always [rayshade4/2 s.6.12].
#include "rayshade/geom/heightfield.h"

#include <algorithm>
#include <cmath>

#include "rayshade/geom/primitive.h"
#include "rayshade/geom/slab.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

constexpr float kHole = -1000;
constexpr int kBlock = 16;
// Neighbouring triangles overlap by this much of the numbers that went into a hit: no gaps.
constexpr double kSlack = 1e-12;
// The walk of a ray that begins farther away starts next to the field: no gaps there either.
constexpr double kNear = 30;

struct Range {
  double low = INFINITY, high = -INFINITY;
  void Include(double z) {
    low = std::min(low, z);
    high = std::max(high, z);
  }
};

bool IsHole(float z) { return !(z > kHole); }

// Over everything that is no hole, and 0.
Range WholeRange(const std::vector<float>& altitudes) {
  Range range{0, 0};
  for (const float z : altitudes) {
    if (!IsHole(z) && std::isfinite(z)) range.Include(z);
  }
  return range;
}

struct FieldHit {
  double distance;
  Vector normal;
};

class Heightfield final : public Geom {
 public:
  explicit Heightfield(const HeightfieldSpec& spec);

  bool closed() const override { return false; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return box_; }
  size_t bytes() const override {
    return sizeof *this + altitudes_->capacity() * sizeof(float) +
           blocks_.capacity() * sizeof(Range);
  }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    FieldHit hit;
    if (!Find(ray, min, max, &hit)) return false;
    *distance = hit.distance;
    return true;
  }

  void Describe(const ObjectRay& ray, double min, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, ReachOf(box_), path);
    FieldHit hit{distance, {0, 0, 1}};
    // The distance may have been taken out of this space and back.
    Find(ray, min, distance + 1e-10 * std::abs(distance), &hit);
    SetNormal(hit.normal, path);
  }

  UvPoint Uv(const HitPath& path) const override {
    return {path.point.x, path.point.y, {1, 0, 0}, {0, 1, 0}};
  }

 private:
  // A walk through the squares of a grid of count x count over the unit square.
  struct Walk;

  float At(int x, int y) const { return (*altitudes_)[static_cast<size_t>(y) * size_ + x]; }
  Vector Corner(int x, int y) const {
    return {x / static_cast<double>(size_ - 1), y / static_cast<double>(size_ - 1), At(x, y)};
  }
  bool Find(const ObjectRay& ray, double min, double max, FieldHit* hit) const;
  bool FindFrom(const ObjectRay& ray, double begin, double min, double max, FieldHit* hit) const;
  bool FindInBlock(const ObjectRay& ray, int block_x, int block_y, double from, double to,
                   double min, double max, FieldHit* hit) const;
  bool MayMeetCell(const ObjectRay& ray, const Walk& walk) const;
  bool FindInCell(const ObjectRay& ray, int x, int y, double min, double max, FieldHit* hit) const;

  int size_;  // samples per side
  int blocks_per_side_;
  std::shared_ptr<const std::vector<float>> altitudes_;
  std::vector<Range> blocks_;
  Bounds box_;
  double reach_;  // largest coordinate in size
};

Heightfield::Heightfield(const HeightfieldSpec& spec)
    : size_(spec.size),
      blocks_per_side_((spec.size - 2) / kBlock + 1),
      altitudes_(spec.altitudes),
      blocks_(static_cast<size_t>(blocks_per_side_) * blocks_per_side_),
      box_(BoxOf(spec)),
      reach_(std::max({1.0, -box_.low.z, box_.high.z})) {
  for (int y = 0; y < size_; ++y) {
    for (int x = 0; x < size_; ++x) {
      const float z = At(x, y);
      if (IsHole(z) || !std::isfinite(z)) continue;
      // A sample on a border belongs to the blocks on both sides.
      for (int b_y = std::max(0, (y - 1) / kBlock);
           b_y <= std::min(y / kBlock, blocks_per_side_ - 1); ++b_y) {
        for (int b_x = std::max(0, (x - 1) / kBlock);
             b_x <= std::min(x / kBlock, blocks_per_side_ - 1); ++b_x) {
          blocks_[static_cast<size_t>(b_y) * blocks_per_side_ + b_x].Include(z);
        }
      }
    }
  }
}

// Steps through squares of side `width` that begin at (x_begin, y_begin), from one distance on; the
// squares of a step are those in which the ray is between `from` and `to`.
struct Heightfield::Walk {
  Walk(const ObjectRay& ray, double width, int low_x, int high_x, int low_y, int high_y,
       double begin)
      : from(begin), low{low_x, low_y}, high{high_x, high_y} {
    for (int axis = 0; axis < 2; ++axis) {
      const double o = ray.origin[axis], d = ray.direction[axis];
      const double at = (o + begin * d) / width;
      const double clamped = std::clamp(std::floor(at), double(low[axis]), double(high[axis]));
      cell[axis] = static_cast<int>(clamped);
      step[axis] = d > 0 ? 1 : -1;
      inverse[axis] = d == 0 ? 0 : 1 / d;
      origin[axis] = o;
      this->width = width;
      next[axis] = Border(axis);
    }
  }
  // The distance at which the ray leaves the present column of squares along this axis.
  double Border(int axis) const {
    if (inverse[axis] == 0) return INFINITY;
    const double border = (cell[axis] + (step[axis] > 0 ? 1 : 0)) * width;
    return (border - origin[axis]) * inverse[axis];
  }
  // Does the ray pass the altitudes of `range` during this step?
  bool Overlaps(const ObjectRay& ray, const Range& range) const {
    const double z_from = ray.origin.z + from * ray.direction.z;
    double z_to = ray.origin.z + to() * ray.direction.z;
    if (!(to() < INFINITY)) z_to = ray.direction.z > 0 ? INFINITY : -INFINITY;
    const double slack = kEpsilon + 1e-9 * std::abs(z_from);
    return std::max(z_from, z_to) + slack >= range.low &&
           std::min(z_from, z_to) - slack <= range.high;
  }
  double to() const { return std::max(from, std::min(next[0], next[1])); }
  bool Advance() {
    const int axis = next[0] < next[1] ? 0 : 1;
    if (!(next[axis] < INFINITY)) return false;
    from = std::max(from, next[axis]);
    cell[axis] += step[axis];
    next[axis] = Border(axis);
    return cell[axis] >= low[axis] && cell[axis] <= high[axis];
  }

  double from;
  int cell[2];
  int low[2], high[2];
  int step[2];
  double inverse[2], origin[2], next[2];
  double width;
};

bool Heightfield::Find(const ObjectRay& ray, double min, double max, FieldHit* hit) const {
  // Where does the walk begin?
  Bounds box = box_;
  box.Grow(kEpsilon);
  double begin = min;
  if (!box.Contains(ray.origin + min * ray.direction)) {
    if (!IntersectSlabs(box, ray.origin, ray.direction, min, INFINITY, &begin)) return false;
    if (!(begin < max)) return false;
  }
  if (begin < kNear) return FindFrom(ray, begin, min, max, hit);
  const ObjectRay near{ray.origin + begin * ray.direction, ray.direction, ray.moment};
  if (!FindFrom(near, 0, min - begin, max - begin, hit)) return false;
  hit->distance += begin;
  return true;
}

bool Heightfield::FindFrom(const ObjectRay& ray, double begin, double min, double max,
                           FieldHit* hit) const {
  const double width = kBlock / static_cast<double>(size_ - 1);
  const int last = blocks_per_side_ - 1;
  Walk walk(ray, width, 0, last, 0, last, begin);
  do {
    if (walk.from > max) return false;
    const Range& range =
        blocks_[static_cast<size_t>(walk.cell[1]) * blocks_per_side_ + walk.cell[0]];
    if (walk.Overlaps(ray, range)) {
      if (FindInBlock(ray, walk.cell[0], walk.cell[1], walk.from, walk.to(), min, max, hit)) {
        return true;
      }
    }
  } while (walk.Advance());
  return false;
}

bool Heightfield::FindInBlock(const ObjectRay& ray, int block_x, int block_y, double from,
                              double to, double min, double max, FieldHit* hit) const {
  const int low_x = block_x * kBlock, low_y = block_y * kBlock;
  Walk walk(ray, 1 / static_cast<double>(size_ - 1), low_x, std::min(low_x + kBlock, size_ - 1) - 1,
            low_y, std::min(low_y + kBlock, size_ - 1) - 1, from);
  do {
    if (walk.from > to || walk.from > max) return false;
    if (MayMeetCell(ray, walk) && FindInCell(ray, walk.cell[0], walk.cell[1], min, max, hit)) {
      return true;
    }
  } while (walk.Advance());
  return false;
}

bool Heightfield::MayMeetCell(const ObjectRay& ray, const Walk& walk) const {
  const int x = walk.cell[0], y = walk.cell[1];
  Range range;
  for (const float z : {At(x, y), At(x + 1, y), At(x, y + 1), At(x + 1, y + 1)}) {
    if (!IsHole(z)) range.Include(z);
  }
  return walk.Overlaps(ray, range);
}

bool Heightfield::FindInCell(const ObjectRay& ray, int x, int y, double min, double max,
                             FieldHit* hit) const {
  const float corner_z[4] = {At(x, y), At(x + 1, y), At(x, y + 1), At(x + 1, y + 1)};
  const Vector right = Corner(x + 1, y), back = Corner(x, y + 1);
  bool found = false;
  // The upper right triangle first: it wins ties.
  for (const bool upper : {true, false}) {
    if (IsHole(corner_z[1]) || IsHole(corner_z[2]) || IsHole(corner_z[upper ? 3 : 0])) continue;
    const Vector v1 = upper ? right : Corner(x, y);
    const Vector v2 = upper ? Corner(x + 1, y + 1) : right;
    const Vector& v3 = back;
    const Vector normal = UnitOf(Cross(v2 - v1, v3 - v1));
    const double u = Dot(normal, ray.origin) - Dot(v1, normal);
    const double v = Dot(normal, ray.direction);
    if ((u <= 0 || v > -kEpsilon) && (u >= 0 || v < kEpsilon)) continue;
    const double s = -u / v;
    if (!(s >= min && s < max)) continue;
    const double h_x = ray.origin.x + s * ray.direction.x;
    const double h_y = ray.origin.y + s * ray.direction.y;
    const double slack = kSlack * reach_ / std::abs(v);
    const bool inside =
        upper ? h_x <= v2.x + slack && h_y <= v2.y + slack && h_x + h_y >= v1.x + v1.y - slack
              : h_x >= v1.x - slack && h_y >= v1.y - slack && h_x + h_y <= v2.x + v2.y + slack;
    if (!inside) continue;
    *hit = {s, normal};
    max = s;
    found = true;
  }
  return found;
}

}  // namespace

std::optional<Complaint> Check(const HeightfieldSpec& spec) {
  if (spec.size < 2 || spec.altitudes == nullptr ||
      spec.altitudes->size() < static_cast<size_t>(spec.size) * spec.size) {
    return Refuse("Not enough heightfield data.", Severity::kError);
  }
  return std::nullopt;
}

Bounds BoxOf(const HeightfieldSpec& spec) {
  const Range range = WholeRange(*spec.altitudes);
  return {{0, 0, range.low}, {1, 1, range.high}};
}

std::unique_ptr<const Geom> Make(const HeightfieldSpec& spec) {
  return std::make_unique<Heightfield>(spec);
}

}  // namespace rayshade
