// The sequential program after parsing: every frame is built, traced and written.
#pragma once

#include <chrono>
#include <string>

#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/scene_builder.h"
#include "rayshade/scene/settings.h"

namespace rayshade {

// Seconds since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The file of one frame: the name as given, or NAME.0003.png where more than one frame is rendered.
std::string FrameFile(const Settings& settings, int frame);

// Returns the exit status: 0, that of the diagnostics, or 130 where a signal ended the run (the
// finished part of the picture is kept for -c). Throws std::runtime_error where a file cannot be
// written. stopwatch: started when the program was.
int RenderPictures(const Options& options, SceneBuilder* scene, Diagnostics* diagnostics,
                   const Stopwatch& stopwatch);

}  // namespace rayshade
