// A small tracer of spheres, the same source for each choice of numbers for boxes, hits and
// shading; for precision.cc. The renderer's own boxes are in single precision, rounded outwards,
// and its hits and shading in double; its test of a sphere is the one used here, one ray and one
// sphere at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "rayshade/common/keyed_random.h"

namespace rayshade::bench {

constexpr int kPixels = 96, kDepth = 5, kLeaf = 4;

template <class T>
struct Vec {
  T x = 0, y = 0, z = 0;
  template <class U>
  explicit operator Vec<U>() const {
    return {static_cast<U>(x), static_cast<U>(y), static_cast<U>(z)};
  }
};
template <class T>
Vec<T> operator+(Vec<T> a, Vec<T> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec<T> operator-(Vec<T> a, Vec<T> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec<T> operator*(T s, Vec<T> a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T Dot(Vec<T> a, Vec<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec<T> Unit(Vec<T> a) {
  return T(1) / std::sqrt(Dot(a, a)) * a;
}
template <class T>
Vec<T> Cross(Vec<T> a, Vec<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Ball {
  Vec<double> center;
  double radius = 0;
  bool mirror = false;
};

template <class B>
struct Node {
  Vec<B> low, high;
  uint32_t first = 0,
           count = 0;  // spheres; count 0: the left child follows, the right one is `first`
};

template <class H>
struct Hit {
  H distance = 0;
  int ball = -1;
};

// B: numbers of boxes, H: of hits.
template <class B, class H>
class Balls {
 public:
  explicit Balls(std::vector<Ball> balls) : balls_(std::move(balls)) {
    Build(0, static_cast<uint32_t>(balls_.size()));
    for (const Ball& ball : balls_) {
      centers_.push_back(static_cast<Vec<H>>(ball.center));
      radii_.push_back(static_cast<H>(ball.radius));
    }
  }

  const std::vector<Ball>& balls() const { return balls_; }
  // The nearest hit in (least, most), or any where `any`.
  Hit<H> Trace(Vec<H> origin, Vec<H> direction, H least, H most, bool any) const;

 private:
  void Build(uint32_t begin, uint32_t end);
  bool Meets(const Node<B>& node, Vec<B> origin, Vec<B> inverse, B most) const;

  std::vector<Ball> balls_;
  std::vector<Node<B>> nodes_;
  std::vector<Vec<H>> centers_;
  std::vector<H> radii_;
};

template <class B, class H>
void Balls<B, H>::Build(uint32_t begin, uint32_t end) {
  const size_t index = nodes_.size();
  nodes_.emplace_back();
  Vec<double> low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  for (uint32_t i = begin; i < end; ++i) {
    const Vec<double> c = balls_[i].center;
    const double r = balls_[i].radius * (1 + 1e-6);
    low = {std::min(low.x, c.x - r), std::min(low.y, c.y - r), std::min(low.z, c.z - r)};
    high = {std::max(high.x, c.x + r), std::max(high.y, c.y + r), std::max(high.z, c.z + r)};
  }
  // Outwards, by more than the conversion and a ray's own rounding take.
  const double slack = 1e-5;
  nodes_[index].low = static_cast<Vec<B>>(low - Vec<double>{slack, slack, slack});
  nodes_[index].high = static_cast<Vec<B>>(high + Vec<double>{slack, slack, slack});
  if (end - begin <= kLeaf) {
    nodes_[index].first = begin;
    nodes_[index].count = end - begin;
    return;
  }
  const Vec<double> size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const uint32_t middle = (begin + end) / 2;
  std::nth_element(balls_.begin() + begin, balls_.begin() + middle, balls_.begin() + end,
                   [axis](const Ball& a, const Ball& b) {
                     const Vec<double>&p = a.center, &q = b.center;
                     return axis == 0 ? p.x < q.x : axis == 1 ? p.y < q.y : p.z < q.z;
                   });
  Build(begin, middle);
  nodes_[index].first = static_cast<uint32_t>(nodes_.size());
  Build(middle, end);
}

template <class B, class H>
bool Balls<B, H>::Meets(const Node<B>& node, Vec<B> o, Vec<B> inverse, B most) const {
  const B x0 = (node.low.x - o.x) * inverse.x, x1 = (node.high.x - o.x) * inverse.x;
  const B y0 = (node.low.y - o.y) * inverse.y, y1 = (node.high.y - o.y) * inverse.y;
  const B z0 = (node.low.z - o.z) * inverse.z, z1 = (node.high.z - o.z) * inverse.z;
  const B enter = std::max({std::min(x0, x1), std::min(y0, y1), std::min(z0, z1), B(0)});
  const B leave = std::min({std::max(x0, x1), std::max(y0, y1), std::max(z0, z1), most});
  return enter <= leave;
}

template <class B, class H>
Hit<H> Balls<B, H>::Trace(Vec<H> origin, Vec<H> direction, H least, H most, bool any) const {
  Hit<H> best{most, -1};
  const Vec<B> o = static_cast<Vec<B>>(origin);
  const Vec<B> inverse{B(1) / B(direction.x), B(1) / B(direction.y), B(1) / B(direction.z)};
  uint32_t stack[64];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const uint32_t index = stack[--size];
    const Node<B>& node = nodes_[index];
    if (!Meets(node, o, inverse, static_cast<B>(best.distance) * B(1.00001))) continue;
    if (node.count == 0) {
      stack[size++] = node.first;
      stack[size++] = index + 1;
      continue;
    }
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Vec<H> to = centers_[i] - origin;
      const H c = Dot(to, direction);
      const Vec<H> p = to - c * direction;
      const H discriminant = radii_[i] * radii_[i] - Dot(p, p);
      if (!(discriminant >= 0)) continue;
      const H root = std::sqrt(discriminant);
      const H distance = c - root > least ? c - root : c + root;
      if (distance > least && distance < best.distance) best = {distance, static_cast<int>(i)};
    }
    if (any && best.ball >= 0) return best;
  }
  return best;
}

// S: numbers of shading, camera included.
template <class B, class H, class S>
class Tracer {
 public:
  explicit Tracer(const std::vector<Ball>& balls) : balls_(balls) {}

  // n x n jittered samples in every pixel.
  std::vector<Vec<double>> Render(int n, uint64_t seed) const;

 private:
  Vec<S> Shade(Vec<S> origin, Vec<S> direction, int depth) const;

  Balls<B, H> balls_;
};

template <class B, class H, class S>
Vec<S> Tracer<B, H, S>::Shade(Vec<S> origin, Vec<S> direction, int depth) const {
  const Hit<H> hit = balls_.Trace(static_cast<Vec<H>>(origin), static_cast<Vec<H>>(direction),
                                  H(1e-5), H(1e14), false);
  if (hit.ball < 0) return {S(.078), S(.361), S(.753)};
  const Ball& ball = balls_.balls()[hit.ball];
  const Vec<S> point = origin + S(hit.distance) * direction;
  Vec<S> normal = S(1) / S(ball.radius) * (point - static_cast<Vec<S>>(ball.center));
  if (Dot(normal, direction) > 0) normal = S(-1) * normal;
  const Vec<S> mirror = direction - S(2) * Dot(direction, normal) * normal;
  Vec<S> color;

  // The light.
  const Vec<S> to_light = Vec<S>{4, 3, 2} - point;
  const S distance = std::sqrt(Dot(to_light, to_light));
  const Vec<S> toward = S(1) / distance * to_light;
  const S cosine = Dot(toward, normal);
  if (cosine > 0 && balls_.Trace(static_cast<Vec<H>>(point), static_cast<Vec<H>>(toward), H(1e-4),
                                 H(distance), true)
                            .ball < 0) {
    const S a = Dot(mirror, toward);
    const S highlight = a > 0 ? S(.5) * std::pow(a, S(3.0827)) : S(0);
    color = color + Vec<S>{S(.5) * cosine + highlight, S(.45) * cosine + highlight,
                           S(.35) * cosine + highlight};
  }
  if (ball.mirror && depth < kDepth) {
    color = color + S(.25) * Shade(point, Unit(mirror), depth + 1);
  }
  return color;
}

template <class B, class H, class S>
std::vector<Vec<double>> Tracer<B, H, S>::Render(int n, uint64_t seed) const {
  const Vec<S> eye{S(2.1), S(1.3), S(1.7)};
  const Vec<S> view = Unit(S(-1) * eye), right = Unit(Cross(view, Vec<S>{0, 0, 1}));
  const Vec<S> up = Cross(right, view);
  const S step = S(2 * std::tan(22.5 * 3.14159265358979 / 180) / kPixels);
  std::vector<Vec<double>> pixels;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      Vec<double> sum;
      for (int i = 0; i < n * n; ++i) {
        const uint64_t key = SampleKey(seed, 0, x, y, i);
        const S u =
            S(x + (i % n + KeyedRandom(key, RandomUse::kJitterX)) / n - .5 * kPixels) * step;
        const S v =
            S(y + (i / n + KeyedRandom(key, RandomUse::kJitterY)) / n - .5 * kPixels) * step;
        sum = sum + static_cast<Vec<double>>(Shade(eye, Unit(view + u * right - v * up), 0));
      }
      pixels.push_back(1. / (n * n) * sum);
    }
  }
  return pixels;
}

}  // namespace rayshade::bench
