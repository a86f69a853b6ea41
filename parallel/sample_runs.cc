// See sample_runs.h.
#include "parallel/sample_runs.h"

namespace rayshade::parallel {

void CheckSample(const Sample& s, const Camera& camera, int samples) {
  const PictureWindow& window = camera.window();
  if (s.x < 0 || s.x >= window.width() || s.y < 0 || s.y > window.height() ||
      s.sub_cell >= samples * samples) {
    throw WireError("a sample that the picture does not have");
  }
}

std::vector<uint64_t> SampleRuns::tokens() const {
  std::vector<uint64_t> tokens;
  tokens.reserve(size_);
  for (const SampleRun& run : runs_) {
    for (uint32_t i = 0; i < run.count(); ++i) tokens.push_back(run.first() + i);
  }
  return tokens;
}

// What lies between two samples of the picture is in it as well.
void SampleRuns::Check(const Camera& camera, int samples) const {
  for (const SampleRun& run : runs_) {
    CheckSample(SampleOf(run.first()), camera, samples);
    CheckSample(SampleOf(run.first() + run.count() - 1), camera, samples);
  }
}

}  // namespace rayshade::parallel
