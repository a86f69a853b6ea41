// How primary rays enter the processes; all that differs in the host between the schedules.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/cell_walk.h"
#include "parallel/expected_owners.h"
#include "parallel/process.h"
#include "parallel/ray_packer.h"
#include "parallel/run_options.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_sampling.h"

namespace rayshade::parallel {

class PrimaryFeed {
 public:
  virtual ~PrimaryFeed() = default;
  virtual void OnRequest(ProcessId) {}
  // Does what can be done before there are requests; nobody waits for it.
  virtual void Prepare(PixelSampling*) {}
  // Hands out samples while there are any, at most `room`, and no more than a step of work; returns
  // how many. Messages that are not full may wait for more samples, until Flush.
  virtual size_t HandOut(size_t room, PixelSampling* sampling, Outbox* outbox) = 0;
  virtual void Flush(Outbox*) {}
  virtual size_t unsent() const { return 0; }  // samples that wait for Flush
  // Cells of the subdivision walked through so far.
  virtual uint64_t cell_steps() const { return 0; }
};

// "There is a host process that issues bundles of rays on request" [RJ s.4]: each request is
// answered by one pyramid, or by up to four in one message while much work is left. Where owners of
// hits are expected, the process that asks gets a pyramid that it is expected to own, before one
// that hits nothing, before one of another's: a hit that is found where it is shaded need not be
// transferred. Of those that are expected to hit nothing sixteen count as one.
class PyramidFeed : public PrimaryFeed {
 public:
  // pyramid: most samples in one.
  PyramidFeed(size_t pyramid, ProcessId processes, ExpectedOwners owners)
      : pyramid_(pyramid), processes_(processes), owners_(std::move(owners)) {}
  void OnRequest(ProcessId from) override { requests_.push_back(from); }
  void Prepare(PixelSampling* sampling) override { LookAhead(sampling); }
  size_t HandOut(size_t room, PixelSampling* sampling, Outbox* outbox) override;

 private:
  struct Pyramid {
    SampleRuns samples;
    ProcessId owner = kHost;  // expected; kHost: nobody is; who asks, where nothing is expected
  };
  SampleRuns Next(PixelSampling* sampling) const;
  void LookAhead(PixelSampling* sampling);
  Pyramid TakeFor(ProcessId process, PixelSampling* sampling);
  size_t VoidsAtOnce(const Picture& picture) const;

  size_t pyramid_;
  ProcessId processes_;
  ExpectedOwners owners_;
  uint64_t handed_out_ = 0;    // samples
  std::deque<Pyramid> ahead_;  // looked at and not handed out, in the picture's order
  size_t voids_ahead_ = 0;     // of those, expected to hit nothing
  std::deque<ProcessId> requests_;
};

// "For each primary ray the host determines which voxel it originates in (or enters) and sends this
// ray as a task to the associated trace process" [RJ s.2]. Rays that enter no cell with objects go
// to the processes in turn.
class DataParallelFeed : public PrimaryFeed {
 public:
  DataParallelFeed(const Camera* camera, const CellTree* tree, ProcessId processes);
  size_t HandOut(size_t room, PixelSampling* sampling, Outbox* outbox) override;
  void Flush(Outbox* outbox) override { packer_.Flush(outbox); }
  size_t unsent() const override { return packer_.size(); }
  uint64_t cell_steps() const override { return cell_steps_; }

 private:
  const Camera* camera_;
  const CellTree* tree_;
  CellWalk walk_;
  ProcessId processes_;
  uint64_t cell_steps_ = 0;
  ProcessId turn_ = 1;
  RayPacker packer_;
  std::vector<Ray> rays_;           // of the step at hand
  std::vector<uint8_t> all_empty_;  // by node
};

}  // namespace rayshade::parallel
