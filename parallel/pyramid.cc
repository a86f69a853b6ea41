// Pyramids by interval arithmetic; see pyramid.h.
#include "parallel/pyramid.h"

#include <algorithm>
#include <cmath>

namespace rayshade::parallel {

namespace {

// The widest that directions may differ along an axis for the bundle to be worth clipping as one.
constexpr double kNarrow = 0.5;

// Distances at which o + t d may lie in [low, high], for o and d in their intervals; d does not
// contain 0.
RayInterval AlongAxis(double low, double high, double o_low, double o_high, double d_low,
                      double d_high) {
  if (d_high < 0) return AlongAxis(-high, -low, -o_high, -o_low, -d_high, -d_low);
  const double enter = low - o_high, leave = high - o_low;  // least and greatest way to go
  return {enter > 0 ? enter / d_high : enter / d_low, leave > 0 ? leave / d_low : leave / d_high};
}

}  // namespace

Pyramid Pyramid::Around(std::span<const Ray> rays) {
  Pyramid p;
  for (const Ray& ray : rays) {
    p.origins.Include(ray.origin);
    p.directions.Include(ray.direction);
  }
  return p;
}

bool Pyramid::narrow() const {
  const Vector spread = directions.high - directions.low;
  return std::max({spread.x, spread.y, spread.z}) < kNarrow;
}

RayInterval Intersect(const Bounds& box, const Pyramid& pyramid) {
  RayInterval all{-HUGE_VAL, HUGE_VAL};
  for (int axis = 0; axis < 3; ++axis) {
    const double d_low = pyramid.directions.low[axis], d_high = pyramid.directions.high[axis];
    const double o_low = pyramid.origins.low[axis], o_high = pyramid.origins.high[axis];
    if (d_low < 1e-100 && d_high > -1e-100) {  // some ray may go either way, or nowhere
      const double reach = std::max(-d_low, d_high);
      if (reach < 1e-100) {
        if (o_high < box.low[axis] || o_low > box.high[axis]) return {1, 0};
        continue;
      }
      // No ray is there before the fastest one has come.
      const double way = std::max(box.low[axis] - o_high, o_low - box.high[axis]);
      if (way > 0) all.entry = std::max(all.entry, way / reach);
      continue;
    }
    const RayInterval here = AlongAxis(box.low[axis], box.high[axis], o_low, o_high, d_low, d_high);
    all.entry = std::max(all.entry, here.entry);
    all.exit = std::min(all.exit, here.exit);
  }
  // Wider than a single ray's interval is rounded.
  if (std::isfinite(all.entry)) all.entry -= 4e-9 * std::abs(all.entry);
  if (std::isfinite(all.exit)) all.exit += 4e-9 * std::abs(all.exit);
  return all;
}

}  // namespace rayshade::parallel
