// Feeds of the three schedules; see primary_feed.h.
#include "parallel/primary_feed.h"

#include <algorithm>

#include "parallel/message.h"

namespace rayshade::parallel {

// How far pyramids may overtake each other: rows of the picture should come in roughly in order.
constexpr size_t kPyramidsAhead = 256;
// Most pyramids in an answer, and how many more answers of that size each process is to get.
constexpr size_t kPyramidsAtOnce = 4, kShares = 8;
// So many that are expected to hit nothing count as one: they are traced before the next answer
// comes.
constexpr size_t kVoidsAsOne = 16;
// Most pyramids in an answer, whatever is expected: others are to find room for their rays as well.
constexpr size_t kMostAtOnce = 32;

SampleRuns PyramidFeed::Next(PixelSampling* sampling) const {
  SampleRuns runs;
  for (const Sample& sample : sampling->Next(pyramid_)) runs.Add(TokenOf(sample));
  return runs;
}

void PyramidFeed::LookAhead(PixelSampling* sampling) {
  while (!owners_.empty() && ahead_.size() < kPyramidsAhead) {
    Pyramid next{Next(sampling)};
    if (next.samples.empty()) break;
    next.owner = owners_.OwnerOf(next.samples);
    voids_ahead_ += next.owner == kHost;
    ahead_.push_back(std::move(next));
  }
}

PyramidFeed::Pyramid PyramidFeed::TakeFor(ProcessId process, PixelSampling* sampling) {
  if (owners_.empty()) return {Next(sampling), process};
  auto best = ahead_.begin();
  const auto rank = [process](const Pyramid& p) {
    return p.owner == process ? 0 : p.owner == kHost ? 1 : 2;
  };
  for (auto p = ahead_.begin(); p != ahead_.end() && rank(*best) > 0; ++p) {
    if (rank(*p) < rank(*best)) best = p;
  }
  if (best == ahead_.end()) return {};
  Pyramid taken = std::move(*best);
  ahead_.erase(best);
  voids_ahead_ -= taken.owner == kHost;
  return taken;
}

// At most so many pyramids answer a request, counted in those that are expected to hit nothing: few
// where a process could be left without at the end, but always one that hits something.
size_t PyramidFeed::VoidsAtOnce(const Picture& picture) const {
  const uint64_t pixels = uint64_t(picture.width()) * picture.height();
  const uint64_t most = (pixels - std::min(pixels, handed_out_)) * kVoidsAsOne / pyramid_;
  const uint64_t left = most - std::min(most, uint64_t(voids_ahead_) * (kVoidsAsOne - 1));
  return std::clamp<uint64_t>(left / (kShares * processes_), kVoidsAsOne,
                              kVoidsAsOne * kPyramidsAtOnce);
}

size_t PyramidFeed::HandOut(size_t room, PixelSampling* sampling, Outbox* outbox) {
  size_t handed_out = 0;
  while (!requests_.empty()) {
    const ProcessId to = requests_.front();
    PrimaryRays message;
    LookAhead(sampling);
    size_t voids = VoidsAtOnce(sampling->picture());
    for (size_t n = kMostAtOnce; n > 0 && voids > 0; --n) {
      if (room - handed_out < pyramid_) break;  // no slivers: wait for results
      const Pyramid pyramid = TakeFor(to, sampling);
      if (pyramid.samples.empty()) break;
      message.samples.Append(pyramid.samples);
      handed_out += pyramid.samples.size();
      voids -= std::min(voids, pyramid.owner == kHost ? 1 : kVoidsAsOne);
    }
    if (message.samples.empty()) break;
    outbox->Send(to, Encode(message));
    requests_.pop_front();
  }
  handed_out_ += handed_out;
  return handed_out;
}

DataParallelFeed::DataParallelFeed(const Camera* camera, const CellTree* tree, ProcessId processes)
    : camera_(camera),
      tree_(tree),
      walk_(tree),
      processes_(processes),
      packer_(processes),
      all_empty_(tree->nodes().size()) {
  const auto& nodes = tree->nodes();
  for (size_t i = nodes.size(); i-- > 0;) {
    const CellNode& n = nodes[i];
    all_empty_[i] =
        n.axis == 3 ? tree->cell(n.low).objects == 0 : all_empty_[n.low] && all_empty_[n.high];
  }
}

size_t DataParallelFeed::HandOut(size_t room, PixelSampling* sampling, Outbox* outbox) {
  constexpr size_t kAtOnce = 1024;
  const std::vector<Sample> samples = sampling->Next(std::min(kAtOnce, room));
  rays_.clear();
  camera_->AppendPrimaryRays(samples, &rays_);
  for (size_t i = 0; i < samples.size(); ++i) {
    const Ray& ray = rays_[i];
    Travel travel;
    travel.back = {kHost, TokenOf(samples[i])};
    cell_steps_ += walk_.Visit(
        ray.origin, ray.direction, kFar, [this](uint32_t node) { return all_empty_[node] != 0; },
        [&travel](CellId cell, const RayInterval&) {
          travel.resume = cell;
          return false;
        });
    ProcessId to = turn_;
    if (travel.resume != kNoCell) {
      to = tree_->cell(travel.resume).owner;
    } else {
      turn_ = turn_ == processes_ ? 1 : turn_ + 1;
    }
    packer_.AddRay(to, ray, {}, travel, outbox);
  }
  return samples.size();
}

}  // namespace rayshade::parallel
