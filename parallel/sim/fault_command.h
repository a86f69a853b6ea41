// prayshade-sim --fault-seed N: renders under a fault plan and compares with the sequential
// picture. What `make seeds` prints for a seed that fails.
#pragma once

#include "parallel/object_spool.h"
#include "parallel/sim/sim_options.h"
#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/options.h"

namespace rayshade::parallel {

// REQUIRES: sim.fault_seed. The exit status: 0 where every frame is the sequential one, 1 where one
// is not. Throws as FaultRun does.
int RenderUnderFaults(const Options& options, const SimOptions& sim, ObjectSpool* spool,
                      Diagnostics* diagnostics);

}  // namespace rayshade::parallel
