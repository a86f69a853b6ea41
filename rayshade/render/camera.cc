// The camera of the generic build (rows from top to bottom) [rayshade4/1 s.7, 8.4-8.6]; see
// camera.h. Expressions keep the order that the specification gives: the last bit of a ray decides
// where it grazes.
#include "rayshade/render/camera.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "rayshade/accel/trace_view.h"
#include "rayshade/render/sample_numbers.h"
#include "rayshade/scene/scene.h"

namespace rayshade {
namespace {

constexpr size_t kTogether = 64;  // rays, within the first cache

PictureWindow CroppedWindow(const Settings& s) {
  const Window w = s.window.value_or(Window{0, s.width - 1, 0, s.height - 1});
  Crop c = s.crop;
  if (c.left > c.right) std::swap(c.left, c.right);
  if (c.low > c.high) std::swap(c.low, c.high);
  const double left = std::max(c.left, 0.0), right = std::min(c.right, 1.0);
  const double low = std::max(c.low, 0.0), high = std::min(c.high, 1.0);
  const double width = double(w.xmax) - w.xmin, height = double(w.ymax) - w.ymin;
  PictureWindow cropped;
  cropped.minx = static_cast<int>(w.xmin + left * width);
  cropped.maxx = static_cast<int>(w.xmin + right * width);
  cropped.miny = static_cast<int>(w.ymin + low * height);
  cropped.maxy = static_cast<int>(w.ymin + high * height);
  return cropped;
}

struct Axes {
  Vector eye, to_look, direction, right, up;
  double distance = 0;
  bool valid = false;
};

Axes AxesFrom(const Vector& eye, const Vector& look, const Vector& up) {
  Axes a;
  a.eye = eye;
  a.to_look = look - eye;
  a.direction = a.to_look;
  a.distance = Normalize(&a.direction);
  a.right = Cross(a.direction, up);
  a.valid = Normalize(&a.right) > 0 && a.distance > 0;
  a.up = Cross(a.right, a.direction);
  Normalize(&a.up);
  return a;
}

Axes ViewAxes(const Settings& s) {
  const Axes mono = AxesFrom(s.eye, s.look, s.up);
  if (s.stereo == StereoEye::kNone || !mono.valid) return mono;
  const double separation = s.eye_separation.value_or(0);
  const double shift = s.stereo == StereoEye::kLeft ? -.5 * separation : .5 * separation;
  return AxesFrom(s.eye + shift * mono.right, s.look, s.up);
}

}  // namespace

Camera::Camera(const Settings& settings, int frame)
    : settings_(settings),
      frame_key_(FrameKey(settings.seed, frame)),
      window_(CroppedWindow(settings)),
      low_discrepancy_(settings.pattern == SamplePattern::kLowDiscrepancy),
      kernels_(ChooseKernels()) {
  const Axes axes = ViewAxes(settings);
  eye_ = axes.eye;
  direction_ = axes.direction;
  right_ = axes.right;
  up_ = axes.up;
  distance_ = axes.distance;

  const double width = settings.width, height = settings.height;
  const double vfov = settings.vfov.value_or(settings.hfov * height / width);
  const double step_x = 2 * distance_ * std::tan(.5 * settings.hfov * kPi / 180) / width;
  const double step_y = 2 * distance_ * std::tan(.5 * vfov * kPi / 180) / height;
  step_x_ = step_x * right_;
  step_y_ = (-step_y) * up_;
  corner_ = axes.to_look - (.5 * height * step_y_ + .5 * width * step_x_);
  filter_width_ = settings.filter_width_used();
  cell_ = filter_width_ * (1.0 / settings.samples);
  frame_start_ = settings.start_time + frame * settings.frame_length;
  if (ObjectsAreStale(settings, frame)) frozen_time_ = frame_start_ + settings.shutter;
  one_alike_ = settings.samples == 1 && !settings.jitter && !low_discrepancy_;
  Ray first;
  double x, y;
  Place({}, &first, &x, &y);
  fresh_.assign(kTogether, first);
}

uint16_t Camera::SingleSubCell(int x, int y) const {
  const uint64_t key = SampleKey(frame_key_, x + window_.minx, y + window_.miny, -1);
  return static_cast<uint16_t>(KeyedRandom(key, RandomUse::kSubCell) * settings_.samples *
                               settings_.samples);
}

Ray Camera::PrimaryRay(const Sample& sample) const {
  Ray ray = fresh_[0];
  SetPrimaryRays({&sample, 1}, &ray);
  return ray;
}

void Camera::AppendPrimaryRays(std::span<const Sample> samples, std::vector<Ray>* rays) const {
  rays->reserve(rays->size() + samples.size());
  for (size_t i = 0; i < samples.size(); i += kTogether) {
    const auto some = samples.subspan(i, std::min(kTogether, samples.size() - i));
    rays->insert(rays->end(), fresh_.begin(), fresh_.begin() + static_cast<ptrdiff_t>(some.size()));
    SetPrimaryRays(some, rays->data() + rays->size() - some.size());
  }
}

// Of up to kTogether rays that are copies of a fresh one.
void Camera::SetPrimaryRays(std::span<const Sample> samples, Ray* rays) const {
  const size_t count = samples.size();
  double x[kTogether], y[kTogether], direction[3][kTogether];
  for (size_t i = 0; i < count; ++i) {
    if (one_alike_) {
      PlaceOneAlike(samples[i], &rays[i], &x[i], &y[i]);
    } else {
      Place(samples[i], &rays[i], &x[i], &y[i]);
    }
  }
  for (size_t i = count; i % 8 != 0; ++i) x[i] = y[i] = 0;
  kernels_.look({{x, y},
                 static_cast<uint32_t>(count),
                 {corner_.x, corner_.y, corner_.z},
                 {{step_x_.x, step_x_.y, step_x_.z}, {step_y_.x, step_y_.y, step_y_.z}},
                 {direction[0], direction[1], direction[2]}});
  for (size_t i = 0; i < count; ++i) {
    rays[i].direction = {direction[0][i], direction[1][i], direction[2][i]};
  }
  if (!(settings_.aperture > 0)) return;
  for (size_t i = 0; i < count; ++i) MoveOnLens(samples[i], &rays[i]);
}

// A place in cell (column, row) of an n x n square.
PlaceInCell Camera::PlaceIn(const Ray& ray, RandomUse use_x, RandomUse use_y, int column,
                            int row) const {
  if (!low_discrepancy_) return {KeyedRandom(ray.key, use_x), KeyedRandom(ray.key, use_y)};
  return LowDiscrepancyPlace(settings_.samples, column, row, PatternKey(ray.sample_number, use_x));
}

int Camera::NumberOf(const Sample& sample) const {
  const int n = settings_.samples, number = SampleNumber(n, sample.sub_cell);
  // From 0 for every n: nothing lies outside of the lens.
  return low_discrepancy_ && n >= 6 ? number - 1 : number;
}

// Where there is one sample per pixel, in its middle: what is not as in a fresh ray.
inline void Camera::PlaceOneAlike(const Sample& sample, Ray* ray, double* x, double* y) const {
  const int px = sample.x + window_.minx, py = sample.y + window_.miny;
  ray->key = SampleKey(frame_key_, px, py, 0);
  *x = px - .5 * filter_width_;
  *y = py - .5 * filter_width_;
}

// All of the ray but its direction, and the place on the screen.
void Camera::Place(const Sample& sample, Ray* primary, double* place_x, double* place_y) const {
  Ray& ray = *primary;
  const int n = settings_.samples;
  const int px = sample.x + window_.minx, py = sample.y + window_.miny;
  const int a = sample.sub_cell % n, b = sample.sub_cell / n;
  ray.key = SampleKey(frame_key_, px, py, sample.sub_cell);
  const int number = NumberOf(sample);
  ray.sample_number = number;
  if (low_discrepancy_) {
    ray.sample_number = WithShift(number, SampleKey(frame_key_, px, py, -1));
  }

  // Place on the screen: the low corner of the sub-cell, or anywhere in it.
  const double width = filter_width_, cell = cell_;
  double x = px - .5 * width, y = py - .5 * width;
  if (sample.single) {
    x += a * cell;
    y += b * cell;
  } else {
    for (int i = 0; i < a; ++i) x += cell;
    for (int i = 0; i < b; ++i) y += cell;
  }
  if (settings_.jitter) {
    const PlaceInCell place = PlaceIn(ray, RandomUse::kJitterX, RandomUse::kJitterY, a, b);
    x += place.x * cell;
    y += place.y * cell;
  }
  *place_x = x;
  *place_y = y;
  ray.origin = eye_;

  // Moment, by the sub-cell's number.
  ray.time = frame_start_;
  if (frozen_time_) {
    ray.time = *frozen_time_;
  } else if (settings_.shutter > 0) {
    const double interval = settings_.shutter / (n * n);
    const double within = settings_.jitter ? KeyedRandom(ray.key, RandomUse::kTime) : 0;
    ray.time = frame_start_ + interval * (number + within);
  }
}

// By the sub-cell's number, too.
void Camera::MoveOnLens(const Sample& sample, Ray* primary) const {
  Ray& ray = *primary;
  const int n = settings_.samples, number = NumberOf(sample);
  const double grid = 2 * (1.0 / n);
  const int column = number % n, row = number / n;
  const PlaceInCell place = PlaceIn(ray, RandomUse::kLensX, RandomUse::kLensY, column, row);
  const double cx = place.x * grid - 1 + column * grid;
  const double cy = place.y * grid - 1 + row * grid;
  const Vector lens = (settings_.aperture * cx) * right_ + (settings_.aperture * cy) * up_;
  const double focus = settings_.focal_distance.value_or(distance_);
  ray.origin = lens + eye_;
  ray.direction = Normalized(focus * ray.direction - lens);
}

Vector Camera::Project(const Vector& point) const {
  const Vector to = point - eye_;
  const double depth = Dot(to, direction_) / distance_;
  const double x = (Dot(to, right_) / depth - Dot(corner_, right_)) / Dot(step_x_, right_);
  const double y = (Dot(to, up_) / depth - Dot(corner_, up_)) / Dot(step_y_, up_);
  return {x - window_.minx, y - window_.miny, depth};
}

std::string CheckView(const Settings& s) {
  if (s.stereo != StereoEye::kNone && !s.eye_separation) {
    return "No eye separation specified for stereo rendering.";
  }
  const PictureWindow w = CroppedWindow(s);
  if (s.width < 1 || s.height < 1 || w.minx < 0 || w.miny < 0 || w.maxx >= s.width ||
      w.maxy >= s.height || w.width() < 1 || w.height() < 1) {
    return "Invalid window specification.";
  }
  if (!ViewAxes(s).valid) return "The view and up directions are identical?";
  if (s.samples < 1 || s.samples > 8) {
    const long long n = s.samples;
    return "Sorry, " + std::to_string(n * n) + " rays/pixel not supported.";
  }
  return "";
}

}  // namespace rayshade
