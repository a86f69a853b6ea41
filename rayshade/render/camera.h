// From samples of the picture to primary rays [rayshade4/1 s.7, 8.4-8.6]. Every process that traces
// primary rays has a camera; a ray is a pure function of settings, frame and sample.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rayshade/common/keyed_random.h"
#include "rayshade/common/ray.h"
#include "rayshade/common/sample_pattern.h"
#include "rayshade/scene/settings.h"

namespace rayshade {

struct Kernels;

// The part of the screen that is rendered, in absolute pixels, both ends included; row 0 is the top
// row.
struct PictureWindow {
  int minx = 0, miny = 0, maxx = 0, maxy = 0;
  int width() const { return maxx - minx + 1; }
  int height() const { return maxy - miny + 1; }
};

// One sample of the picture. x, y relative to the window; y may be height() (the extra row below,
// rayshade4/1 s.8.3).
struct Sample {
  int32_t x = 0, y = 0;
  uint16_t sub_cell = 0;
  // 1: the first sample of a pixel, whose position rounds differently [rayshade4/1 s.8.4]. As wide
  // as it is so that nothing is left of three words, which are then copied as such.
  uint16_t single = 0;
  bool operator==(const Sample&) const = default;
};

class Camera {
 public:
  // REQUIRES: CheckView(settings) is empty.
  Camera(const Settings& settings, int frame);

  Ray PrimaryRay(const Sample& sample) const;
  void AppendPrimaryRays(std::span<const Sample> samples, std::vector<Ray>* rays) const;
  // Where a point of the world is seen through the middle of the lens: x and y in pixels of the
  // window, z its depth in distances from the eye to the point looked at; not in front where z <=
  // 0, then x and y mean nothing.
  Vector Project(const Vector& point) const;
  // The sub-cell that the single sample of a pixel falls into.
  uint16_t SingleSubCell(int x, int y) const;
  const PictureWindow& window() const { return window_; }
  const Vector& eye() const { return eye_; }

 private:
  void SetPrimaryRays(std::span<const Sample> samples, Ray* rays) const;
  void Place(const Sample& sample, Ray* ray, double* x, double* y) const;
  void PlaceOneAlike(const Sample& sample, Ray* ray, double* x, double* y) const;
  void MoveOnLens(const Sample& sample, Ray* ray) const;
  PlaceInCell PlaceIn(const Ray& ray, RandomUse use_x, RandomUse use_y, int column, int row) const;
  int NumberOf(const Sample& sample) const;  // in the order tables

  Settings settings_;
  uint64_t frame_key_;
  PictureWindow window_;
  bool low_discrepancy_;
  Vector eye_, direction_, right_, up_;  // unit axes
  Vector corner_, step_x_, step_y_;      // [rayshade4/1 s.7.3]
  double distance_ = 0;
  double filter_width_ = 0, cell_ = 0;  // of a sub-cell
  double frame_start_ = 0;
  std::optional<double> frozen_time_;  // of all rays
  const Kernels& kernels_;
  bool one_alike_ = false;  // samples differ in their pixels only
  std::vector<Ray> fresh_;  // rays that have what is the same for all, to be copied
};

// What is wrong with the view or the sampling, in Rayshade's words, or "".
std::string CheckView(const Settings& settings);

}  // namespace rayshade
