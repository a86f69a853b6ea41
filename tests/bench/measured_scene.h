// For `make accuracy`: a scene that is rendered in many ways, each picture beside a converged one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rayshade/common/color.h"
#include "rayshade/scene/scene_builder.h"

namespace rayshade::bench {

// Changes the settings of a scene to those of one way of rendering.
using Way = std::function<void(Settings*)>;

// What a way costs and how wrong it is.
struct Point {
  std::string curve, parameter;
  double time_ratio = 0;   // tracing time in yardsticks: one sample per pixel without jitter, and
                           // one shadow ray for each light
  double error = 0;        // root mean square over pixels and channels, in 1/255
  double share_off = 0;    // percent of pixels with a channel off by more than 2/255
  double samples = 0;      // primary rays per pixel
  double shadow_rays = 0;  // per pixel
  double secondary_rays = 0;  // per pixel
  bool front = false;         // worth using
};

class MeasuredScene {
 public:
  // Reads a scene file; width and height replace what it says, defines are for its preprocessor.
  // Ends the program where that fails.
  MeasuredScene(const std::string& file, int width, int height, const std::string& defines = "");
  ~MeasuredScene();

  // The reference is the mean of `seeds` pictures of n x n jittered samples in every pixel, with
  // everything else as `base` leaves the scene's settings.
  void Converge(int n, int seeds, const Way& base);
  void ConvergeAs(const MeasuredScene& other) { reference_ = other.reference_; }
  // Takes the median of up to `runs` runs (fewer where they take long), each beside the yardstick.
  // REQUIRES: Converge.
  Point Measure(const std::string& curve, const std::string& parameter, const Way& way, int runs);

 private:
  struct Rendered;
  Rendered Render(const Way& way);
  void Compare(const Rendered& rendered, Point* point) const;

  SceneBuilder builder_;
  SceneBuilder::Built built_;
  Settings settings_;
  std::vector<Color> reference_;  // clamped
};

// Marks the points that none is better than in time and error. Of points within a few percent of
// each other, which the next measurement may turn round, one is marked. Those named --quality
// repeat others and are left out.
void MarkFront(std::vector<Point>* points);
void WriteCsv(const std::string& file, const std::vector<Point>& points);

}  // namespace rayshade::bench
