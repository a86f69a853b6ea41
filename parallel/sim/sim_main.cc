// prayshade-sim: options, then the scene into the spool, then its pictures on a simulated machine.
#include <exception>
#include <new>

#include "parallel/object_spool.h"
#include "parallel/sim/fault_command.h"
#include "parallel/sim/sim_options.h"
#include "parallel/sim/sim_run.h"
#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/parse.h"

int main(int argc, char** argv) {
  using namespace rayshade;
  using namespace rayshade::parallel;
  const OptionsResult result = ParseOptions(argc, argv, SimLongOptions());
  if (!result.options) return result.status;
  const Options& options = *result.options;
  Diagnostics diagnostics(options.program);
  diagnostics.set_quiet(options.quiet);
  try {
    const SimOptions sim = ParseSimOptions(options);
    ObjectSpool spool;
    if (!ParseScene(options, &diagnostics, &spool)) return diagnostics.exit_status();
    if (sim.fault_seed) return RenderUnderFaults(options, sim, &spool, &diagnostics);
    return SimRun(options, sim, &spool, &diagnostics).Run();
  } catch (const std::bad_alloc&) {
    diagnostics.Report(Severity::kError, {}, "Out of memory.");
  } catch (const std::exception& e) {
    diagnostics.Report(Severity::kError, {}, e.what());
  }
  return diagnostics.exit_status();
}
