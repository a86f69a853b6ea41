// The blob; see blob.h. The ray is cut where it enters and leaves the balls; on each piece the
// field is a quartic, set up from the beginning of the piece. The sign of field - threshold is
// carried from piece to piece, so that no crossing is lost between two of them, and a ray that
// begins on the surface does not take its own origin for the next crossing (Rayshade then loses
// the true exit [rayshade4/2 s.6.11]).
#include "rayshade/geom/blob.h"

#include <algorithm>
#include <cmath>

#include "rayshade/geom/primitive.h"
#include "rayshade/geom/quartic.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

// strength (1 - d^2 / radius^2)^2 = c4 d^4 + c2 d^2 + c0.
struct Ball {
  Vector center;
  double radius2, c4, c2, c0;
};

struct End {
  double distance;
  bool entry;
  const Ball* ball;
};

// Room for `capacity` items, without allocation for a few of them.
template <typename T>
class Buffer {
 public:
  explicit Buffer(size_t capacity) : many_(capacity > kFew ? capacity : 0) {
    items_ = capacity > kFew ? many_.data() : few_;
  }
  void Add(const T& item) { items_[size_++] = item; }
  void Remove(const T& item) { size_ = std::remove(begin(), end(), item) - begin(); }
  T* begin() { return items_; }
  T* end() { return items_ + size_; }
  bool empty() const { return size_ == 0; }

 private:
  static constexpr size_t kFew = 24;
  T few_[kFew];
  std::vector<T> many_;
  T* items_;
  size_t size_ = 0;
};

// Adds the ball's field along the ray, as a polynomial of the distance from `from`.
void AddField(const Ball& ball, const ObjectRay& ray, double from, Quartic* q) {
  const Vector o = (ray.origin - ball.center) + from * ray.direction;
  const double a1 = Dot(o, ray.direction), a0 = Dot(o, o);
  q->c[4] += ball.c4;
  q->c[3] += 4 * ball.c4 * a1;
  q->c[2] += 2 * ball.c4 * (2 * a1 * a1 + a0) + ball.c2;
  q->c[1] += 2 * a1 * (2 * ball.c4 * a0 + ball.c2);
  q->c[0] += ball.c4 * a0 * a0 + ball.c2 * a0 + ball.c0;
}

class Blob final : public Geom {
 public:
  explicit Blob(const BlobSpec& spec) : threshold_(spec.threshold) {
    // Written last, summed first, as in Rayshade.
    for (auto ball = spec.balls.rbegin(); ball != spec.balls.rend(); ++ball) {
      const double r2 = ball->radius * ball->radius, s = ball->strength;
      balls_.push_back({ball->center, r2, s / (r2 * r2), -2 * s / r2, s});
    }
    bounds_ = BoxOf(spec);
  }

  bool closed() const override { return true; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return bounds_; }
  size_t bytes() const override { return sizeof *this + balls_.capacity() * sizeof(Ball); }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override;

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, ReachOf(bounds_), path);
    Vector normal;
    for (const Ball& ball : balls_) {
      const Vector from = path->point - ball.center;
      const double d2 = Dot(from, from);
      if (d2 <= ball.radius2) normal = normal + -2 * (2 * ball.c4 * d2 + ball.c2) * from;
    }
    SetNormal(UnitOf(normal), path);
  }

 private:
  // The first crossing beyond min; ends: sorted.
  bool Search(const ObjectRay& ray, double min, Buffer<End>* ends, double* distance) const;

  double threshold_;
  std::vector<Ball> balls_;
  Bounds bounds_;
};

bool Blob::Intersect(const ObjectRay& ray, double min, double max, double* distance) const {
  // Which part of the ray lies inside each ball?
  Buffer<End> ends(2 * balls_.size());
  for (const Ball& ball : balls_) {
    const Vector c = ball.center - ray.origin;
    const double b = Dot(c, ray.direction);
    const Vector p = c - b * ray.direction;
    const double q = ball.radius2 - Dot(p, p);
    if (!(q > 0)) continue;
    const double root = std::sqrt(q);
    const double entry = std::max(b - root, min), exit = b + root;
    if (!(exit > entry)) continue;
    ends.Add({entry, true, &ball});
    ends.Add({exit, false, &ball});
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const End& a, const End& b) { return a.distance < b.distance; });
  double s;
  if (!Search(ray, min, &ends, &s) || !(s > min && s < max)) return false;
  *distance = s;
  return true;
}

bool Blob::Search(const ObjectRay& ray, double min, Buffer<End>* ends, double* distance) const {
  const int sign_outside = threshold_ < 0 ? 1 : -1;
  if (ends->empty()) return false;
  // Where the ray begins inside of balls, the sign is that of the first piece.
  int sign = ends->begin()->distance > min ? sign_outside : 0;
  Buffer<const Ball*> active(balls_.size());
  double low = 0;
  for (const End& end : *ends) {
    if (!active.empty() && end.distance > low) {
      Quartic q;
      for (const Ball* ball : active) AddField(*ball, ray, low, &q);
      q.c[0] -= threshold_;
      double roots[5];
      if (SignChanges(q, 0, end.distance - low, &sign, roots) > 0) {
        *distance = low + roots[0];
        return true;
      }
    }
    low = end.distance;
    if (end.entry) {
      active.Add(end.ball);
    } else {
      active.Remove(end.ball);
      if (active.empty()) sign = sign_outside;
    }
  }
  return false;
}

}  // namespace

std::optional<Complaint> Check(const BlobSpec& spec) {
  if (spec.balls.empty() || !std::isfinite(spec.threshold)) {
    return Refuse("blob field not correct.");
  }
  for (const BlobSpec::Ball& ball : spec.balls) {
    if (!(ball.strength >= kEpsilon && ball.radius >= kEpsilon) ||
        !std::isfinite(ball.strength + ball.radius) || !IsFinite(ball.center)) {
      return Refuse("Degenerate metaball in blob (sr).");
    }
  }
  return std::nullopt;
}

Bounds BoxOf(const BlobSpec& spec) {
  Bounds box;
  for (const BlobSpec::Ball& ball : spec.balls) {
    const Vector r{ball.radius, ball.radius, ball.radius};
    box.Include({ball.center - r, ball.center + r});
  }
  return box;
}

std::unique_ptr<const Geom> Make(const BlobSpec& spec) { return std::make_unique<Blob>(spec); }

}  // namespace rayshade
