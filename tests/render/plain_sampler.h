// The sampling rule written down as one reads it, recursion free and one ray at a time [rayshade4/1
// s.8], and the base scene of the specification's table of counts [rayshade4/1 s.14.1]: the model
// that PixelSampling is tested against. Random numbers come from outside: the original's stream, or
// keys.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "rayshade/common/keyed_random.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_filter.h"
#include "rayshade/scene/settings.h"
#include "rayshade/shade/ray_result.h"

namespace rayshade {

// Two flat spheres before a blue ground.
inline RayResult TraceTwoSpheres(const Ray& ray) {
  struct Ball {
    Vector center;
    double radius;
    Color color;
  };
  const Ball balls[] = {{{0, 0, 0}, 2, {.9, .5, .2}}, {{1.5, 0, 1.5}, 1, {.2, .5, .9}}};
  RayResult result{{.1, .2, .3}, kFar, false};
  for (const Ball& ball : balls) {
    const Vector to = ball.center - ray.origin;
    const double b = Dot(to, ray.direction);
    const double d = b * b - Dot(to, to) + ball.radius * ball.radius;
    if (d < 0) continue;
    const double root = std::sqrt(d);
    const double t = b - root > kEpsilon ? b - root : b + root;
    if (t > kEpsilon && t < result.distance) result = {ball.color, t, true};
  }
  return result;
}

inline Settings TwoSpheresSettings(int width, int height) {
  Settings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

class PlainSampler {
 public:
  using Random = std::function<double(int x, int y, int sub_cell, RandomUse use)>;
  using Trace = std::function<RayResult(const Ray&)>;

  // No lens, no shutter.
  PlainSampler(const Settings& s, Random random, Trace trace)
      : s_(s), random_(random), trace_(trace), weights_(FilterWeights(s)) {
    right_ = {1, 0, 0};
    const double vfov = s.hfov * s.height / s.width;
    step_x_ = 2 * 10 * std::tan(.5 * s.hfov * kPi / 180) / s.width * right_;
    step_y_ = -(2 * 10 * std::tan(.5 * vfov * kPi / 180) / s.height) * Vector{0, 0, 1};
    corner_ = Vector{0, 10, 0} - (.5 * s.height * step_y_ + .5 * s.width * step_x_);
    pixels_.resize(size_t(s.width) * (s.height + 1));
    Run();
  }

  const Color& at(int x, int y) const { return pixels_[size_t(y) * s_.width + x].color; }
  int eye_rays() const { return eye_rays_; }
  int supersampled() const { return supersampled_; }

 private:
  struct Pixel {
    Color color;
    int single = -1;
    bool full = false;
  };
  Pixel& pixel(int x, int y) { return pixels_[size_t(y) * s_.width + x]; }

  void Run() {
    const int w = s_.width, h = s_.height;
    for (int x = 0; x < w; ++x) Full(x, 0);
    SingleRow(1);
    for (int y = 1; y < h; ++y) {
      SingleRow(y + 1);
      for (bool changed = s_.samples > 1; changed;) {
        changed = false;
        for (int x = 1; x < w - 1; ++x) changed |= Refine(x, y);
      }
    }
    for (int x = 1; x < w - 1; ++x) Full(x, h - 1);
  }
  void SingleRow(int y) {
    for (int x = 0; x < s_.width; ++x) Single(x, y);
    Full(0, y);
    Full(s_.width - 1, y);
  }
  bool Refine(int x, int y) {
    const std::array<Pixel*, 5> cross = {&pixel(x - 1, y), &pixel(x, y - 1), &pixel(x + 1, y),
                                         &pixel(x, y + 1), &pixel(x, y)};
    const Color* colors[5];
    for (int i = 0; i < 5; ++i) colors[i] = &cross[i]->color;
    if (!ContrastFires(colors, s_.contrast)) return false;
    const int before = supersampled_;
    Full(x - 1, y);
    Full(x, y - 1);
    Full(x + 1, y);
    Full(x, y + 1);
    Full(x, y);
    return supersampled_ > before;
  }
  void Single(int x, int y) {
    const int n = s_.samples;
    const int c = static_cast<int>(random_(x, y, -1, RandomUse::kSubCell) * n * n);
    const double w = s_.filter_width_used(), d = w * (1.0 / n);
    const double dy = s_.jitter ? random_(x, y, c, RandomUse::kJitterY) * d : 0;
    const double dx = s_.jitter ? random_(x, y, c, RandomUse::kJitterX) * d : 0;
    pixel(x, y).color = Shoot(x - .5 * w + (c % n) * d + dx, y - .5 * w + (c / n) * d + dy);
    pixel(x, y).single = c;
  }
  void Full(int x, int y) {
    Pixel& p = pixel(x, y);
    if (p.full) return;
    p.full = true;
    ++supersampled_;
    const int n = s_.samples;
    if (n == 1 && p.single >= 0) return;
    p.color = p.single < 0 ? Color{} : weights_[p.single] * p.color;
    const double w = s_.filter_width_used(), d = w * (1.0 / n);
    double v = y - .5 * w;
    for (int b = 0; b < n; ++b, v += d) {
      double u = x - .5 * w;
      for (int a = 0; a < n; ++a, u += d) {
        const int c = b * n + a;
        if (c == p.single) continue;
        const double dx = s_.jitter ? random_(x, y, c, RandomUse::kJitterX) * d : 0;
        const double dy = s_.jitter ? random_(x, y, c, RandomUse::kJitterY) * d : 0;
        p.color += weights_[c] * Shoot(u + dx, v + dy);
      }
    }
  }
  Color Shoot(double x, double y) {
    ++eye_rays_;
    Ray ray;
    ray.origin = {0, -10, 0};
    ray.direction = Normalized(corner_ + x * step_x_ + y * step_y_);
    return trace_(ray).color;
  }

  Settings s_;
  Random random_;
  Trace trace_;
  std::vector<double> weights_;
  Vector right_, step_x_, step_y_, corner_;
  std::vector<Pixel> pixels_;
  int eye_rays_ = 0, supersampled_ = 0;
};

}  // namespace rayshade
