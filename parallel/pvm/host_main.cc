// prayshade: options, then the scene into the spool, then its pictures by many processes.
#include <exception>
#include <new>
#include <stdexcept>

#include "parallel/object_spool.h"
#include "parallel/parallel_options.h"
#include "parallel/pvm/compare.h"
#include "parallel/pvm/host_run.h"
#include "rayshade/common/diagnostics.h"
#include "rayshade/common/transform_chain.h"
#include "rayshade/render/render_picture.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/parse.h"

int main(int argc, char** argv) {
  using namespace rayshade;
  using namespace rayshade::parallel;
  const Stopwatch stopwatch;
  const OptionsResult result = ParseOptions(argc, argv, ParallelLongOptions());
  if (!result.options) return result.status;
  const Options& options = *result.options;
  Diagnostics diagnostics(options.program);
  diagnostics.set_quiet(options.quiet);
  try {
    const ParallelOptions parallel = ParseParallelOptions(options);
    if (parallel.compare) CheckComparable(options);
    ObjectSpool spool;
    if (!ParseScene(options, &diagnostics, &spool)) return diagnostics.exit_status();
    HostRun run(options, parallel, &spool, &diagnostics, stopwatch);
    const int status = run.Run();
    if (status != 0 || !parallel.compare) return status;
    return Compare({argv, argv + argc}, parallel, spool.settings(), run.statistics());
  } catch (const std::bad_alloc&) {
    diagnostics.Report(Severity::kError, {}, "Out of memory.");
  } catch (const DegenerateTransform& e) {
    diagnostics.Report(Severity::kFatal, {}, e.what());
  } catch (const std::exception& e) {
    diagnostics.Report(Severity::kError, {}, e.what());
  }
  return diagnostics.exit_status();
}
