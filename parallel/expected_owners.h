// Which process is expected to own what a primary ray hits: the owner of the cell that is predicted
// for its square of the picture (balanced_distribution.h).
#pragma once

#include <algorithm>
#include <vector>

#include "parallel/balanced_distribution.h"
#include "parallel/cell_tree.h"
#include "parallel/sample_runs.h"
#include "rayshade/render/camera.h"

namespace rayshade::parallel {

class ExpectedOwners {
 public:
  ExpectedOwners() = default;  // nothing is known
  ExpectedOwners(const PredictedHits& hits, const CellTree& tree, const PictureWindow& window)
      : across_(hits.across), width_(window.width()), height_(window.height()) {
    for (const CellId c : hits.cells) {
      owners_.push_back(c == kNoCell ? kHost : tree.cell(c).owner);
      processes_ = std::max(processes_, owners_.back());
    }
  }

  bool empty() const { return owners_.empty(); }

  // The owner of most hits; kHost: none is expected. The first of a run tells for it, and of many
  // runs some tell.
  ProcessId OwnerOf(const SampleRuns& samples) const {
    constexpr size_t kTell = 64;
    std::vector<size_t> votes(processes_ + size_t{1});
    const std::vector<SampleRun>& runs = samples.runs();
    const size_t step = runs.size() / kTell | 1;  // odd: not always the same columns
    for (size_t i = 0; i < runs.size(); i += step) {
      votes[owners_[Square(SampleOf(runs[i].first()))]] += runs[i].count();
    }
    votes[kHost] = 0;  // the first of the largest: where all are 0, it is this one
    return static_cast<ProcessId>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }

 private:
  size_t Square(const Sample& s) const {
    const int x = std::min(across_ - 1, s.x * across_ / width_);
    const int y =
        std::min(across_ - 1, s.y * across_ / height_);  // there is a row below the picture
    return size_t(y) * across_ + x;
  }

  int across_ = 0, width_ = 1, height_ = 1;
  ProcessId processes_ = 0;
  std::vector<ProcessId> owners_;  // by square
};

}  // namespace rayshade::parallel
