// Which samples a picture needs, by Rayshade's rule: every pixel one sample, then full sets where
// the contrast demands them [rayshade4/1 s.8]. Nobody traces here: the sequential tracer and the
// host of a parallel run ask for samples, trace them in whatever way, and put the results in, in
// any order.
//
//   1. The picture is a pure function of the samples' results: the rule is applied in Rayshade's
//   order whatever the
//      order of arrival.
//   2. With ahead = 0 exactly the samples of the rule are asked for. With ahead > 0 full sets are
//   also asked for where the
//      test may fire, so that many samples are in flight at once; what was not needed is counted as
//      speculative.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rayshade/image/picture.h"
#include "rayshade/render/camera.h"
#include "rayshade/shade/ray_result.h"

namespace rayshade {

class PixelSampling {
 public:
  PixelSampling(const Settings& settings, const Camera& camera, bool ahead);
  ~PixelSampling();

  // Up to `most` samples to trace next: neighbouring pixels, as square a group as `most` allows.
  // Empty where nothing can be asked for before further results are in, or when all is done.
  std::vector<Sample> Next(size_t most);
  // The result of a sample that Next gave, each once.
  void Put(const Sample& sample, const RayResult& result);
  void Put(std::span<const Sample> samples, std::span<const RayResult> results);
  // Of `count` samples side by side in a row, from `first` on, that all have the same result.
  void PutRun(const Sample& first, int count, const RayResult& result);

  bool done() const;             // every pixel of the picture is final
  int rows_done() const;         // final rows, from the top
  double fraction_done() const;  // an estimate, 0 to 1
  const Picture& picture() const;
  uint64_t supersampled_pixels() const;
  uint64_t speculative_samples() const;  // known when done

  // What has been reached, as bytes: a picture that was cut short goes on from there, to the same
  // end.
  std::string Save() const;
  // REQUIRES: nothing asked for yet, and the settings that Save was called with. False where the
  // bytes are not such a state; then nothing has changed.
  bool Restore(const std::string& bytes);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayshade
