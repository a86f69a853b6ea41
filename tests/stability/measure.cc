// Rays beside the truth; see measure.h.
#include "tests/stability/measure.h"

#include <algorithm>
#include <random>

#include "tests/stability/crossings.h"

namespace rayshade::stability {
namespace {

using Random = std::mt19937_64;

constexpr double kBeyond = 1e300;
constexpr double kMisplaced = 1e-5;
constexpr double kSame = 1e-5;  // crossings nearer to each other count once

struct Shot {
  Vector origin, direction;
};

double Coordinate(Random* random) {
  return 2 * (static_cast<double>((*random)() >> 11) * 0x1.0p-53) - 1;
}

Vector InBall(Random* random) {
  for (;;) {
    const Vector p{Coordinate(random), Coordinate(random), Coordinate(random)};
    if (Dot(p, p) <= 1 && Dot(p, p) > .01) return p;
  }
}

Shot Aim(const Subject& subject, double size, double distance, Random* random) {
  for (;;) {
    Shot shot;
    const Vector target = subject.center + 1.25 * subject.reach * InBall(random);
    shot.direction = Normalized(InBall(random));
    const double away = std::max(distance, 4.0) * size;
    shot.origin = target - away * shot.direction;
    if (distance >= 1) return shot;
    // Nearer: from in front of the surface.
    const auto truth = CrossingsOf<Quad>(subject.spec, subject.scale, shot.origin, shot.direction);
    if (truth.empty() || truth[0].cosine < Quad(.1)) continue;
    shot.origin =
        shot.origin + (static_cast<double>(truth[0].distance) - distance * size) * shot.direction;
    return shot;
  }
}

// Distances of different crossings, first one first.
std::vector<double> Apart(std::vector<double> distances, double same) {
  std::vector<double> apart;
  for (const double s : distances) {
    if (apart.empty() || s - apart.back() > same) apart.push_back(s);
  }
  return apart;
}

std::vector<double> OurCrossings(const Subject& subject, const Shot& shot, double same) {
  std::vector<double> found;
  double min = 0;
  while (found.size() < 20) {
    const auto s = subject.Intersect(shot.origin, shot.direction, min, kBeyond);
    if (!s) break;
    found.push_back(*s);
    min = *s + same;
  }
  return found;
}

// One solution's errors over all rays.
class Tally {
 public:
  explicit Tally(double size) : size_(size) {}

  void Add(const std::vector<double>& found, const Crossings<Quad>& truth,
           const std::vector<double>& true_distances) {
    errors_.wrong += found.empty() != truth.empty();
    errors_.wrong_counts += found.size() != true_distances.size();
    if (found.empty() || truth.empty()) return;
    const double off = static_cast<double>(Size(Quad(found[0]) - truth[0].distance)) / size_;
    errors_.misplaced += off > kMisplaced;
    offs_.push_back(off * static_cast<double>(truth[0].cosine));
  }

  Errors Result() {
    if (offs_.empty()) return errors_;
    std::sort(offs_.begin(), offs_.end());
    errors_.median = offs_[offs_.size() / 2];
    errors_.worst = offs_.back();
    return errors_;
  }

 private:
  double size_;
  Errors errors_;
  std::vector<double> offs_;
};

}  // namespace

Measurement Measure(const Subject& subject, double size, double distance, int rays) {
  Random random(static_cast<uint64_t>(1000 + 10 * std::log10(distance)));
  const double same = kSame * size;
  Measurement m;
  Tally ours(size), plain(size);
  for (m.rays = 0; m.rays < rays; ++m.rays) {
    const Shot shot = Aim(subject, size, distance, &random);
    const auto truth = CrossingsOf<Quad>(subject.spec, subject.scale, shot.origin, shot.direction);
    std::vector<double> true_distances, plain_distances;
    for (const auto& c : truth) true_distances.push_back(static_cast<double>(c.distance));
    for (const auto& c :
         CrossingsOf<double>(subject.spec, subject.scale, shot.origin, shot.direction)) {
      plain_distances.push_back(c.distance);
    }
    true_distances = Apart(true_distances, same);
    m.hits += !truth.empty();
    ours.Add(OurCrossings(subject, shot, same), truth, true_distances);
    plain.Add(Apart(plain_distances, same), truth, true_distances);
  }
  m.ours = ours.Result();
  m.plain = plain.Result();
  return m;
}

}  // namespace rayshade::stability
