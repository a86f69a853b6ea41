// Bounds of rounding; see slack.h.
#include "rayshade/shade/slack.h"

namespace rayshade {
namespace {

constexpr double kRoundings = 256 * 0x1.0p-53;

// What each coordinate of a sum is made of.
Vector Sizes(const Matrix& a, const Vector& sizes) {
  Vector sum;
  for (int to = 0; to < 3; ++to) {
    for (int from = 0; from < 3; ++from) sum[to] += sizes[from] * std::abs(a.m[from][to]);
  }
  return sum;
}

Vector Sizes(const Vector& a) { return {std::abs(a.x), std::abs(a.y), std::abs(a.z)}; }

}  // namespace

double SlackOf(const Ray& ray, double reach, double distance) {
  return kRoundings * (SumOfSizes(ray.origin) + distance + reach);
}

double SlackOf(const Ray& ray, const HitPath& path, double distance, const Transform& to_world) {
  const double within = path.distance + path.reach;
  const Vector inside = Sizes(to_world.inverse_matrix, Sizes(ray.origin)) +
                        Sizes(to_world.inverse_translation) + Vector{within, within, within};
  const Vector outside = Sizes(to_world.matrix, inside) + Sizes(to_world.translation);
  return kRoundings * (SumOfSizes(ray.origin) + distance + SumOfSizes(outside));
}

}  // namespace rayshade
