// Names of schedules; see run_options.h.
#include "parallel/run_options.h"

namespace rayshade::parallel {

const char* Name(Schedule schedule) {
  switch (schedule) {
    case Schedule::kDataParallel:
      return "data-parallel";
    case Schedule::kDemandDriven:
      return "demand-driven";
    case Schedule::kHybrid:
      return "hybrid";
  }
  return "?";
}

const char* Name(Shadows shadows) { return shadows == Shadows::kLocal ? "local" : "travel"; }

}  // namespace rayshade::parallel
