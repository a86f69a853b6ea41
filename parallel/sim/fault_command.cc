// See fault_command.h.
#include "parallel/sim/fault_command.h"

#include <algorithm>
#include <cstdio>

#include "parallel/sim/fault_run.h"
#include "parallel/sim/sequential_base.h"
#include "parallel/sim/sim_run.h"
#include "parallel/sim/transcript_file.h"

namespace rayshade::parallel {

int RenderUnderFaults(const Options& options, const SimOptions& sim, ObjectSpool* spool,
                      Diagnostics* diagnostics) {
  const Settings settings = spool->settings();
  const FaultPlan plan = PlanFaults(*sim.fault_seed);
  if (!options.quiet) std::fprintf(stderr, "seed %s\n", plan.Text().c_str());
  TranscriptFile transcript(sim.transcript_file);
  for (int frame = settings.first_frame;
       frame < settings.first_frame + std::max(settings.frames, 1); ++frame) {
    spool->Place(frame);
    FaultRun run(plan, spool, frame, transcript.get());
    run.Run();
    WriteFrame(run.picture(), settings, frame);

    Picture sequential(0, 0);
    SequentialWork(spool, frame, &sequential);
    if (const auto difference = DifferenceOf(sequential, run.picture())) {
      diagnostics->Report(Severity::kError, {},
                          "the picture is not the sequential one: " + *difference);
      return diagnostics->exit_status();
    }
    if (!options.quiet) {
      std::fprintf(stderr, "the sequential picture, after %llu events\n",
                   static_cast<unsigned long long>(run.events()));
    }
  }
  return 0;
}

}  // namespace rayshade::parallel
