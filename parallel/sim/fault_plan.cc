// See fault_plan.h.
#include "parallel/sim/fault_plan.h"

#include <cmath>

#include "parallel/work_queue.h"
#include "rayshade/common/keyed_random.h"

namespace rayshade::parallel {

namespace {

double UnitOf(uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

// Draws one after another from a seed.
class Draws {
 public:
  explicit Draws(uint64_t seed) : random_(MixBits(seed)) {}
  double Unit() { return UnitOf(random_ = MixBits(random_)); }
  bool Chance(double share) { return Unit() < share; }
  uint64_t Below(uint64_t n) { return static_cast<uint64_t>(Unit() * static_cast<double>(n)); }
  // From least to most, small ones more often.
  uint64_t Low(uint64_t least, uint64_t most) {
    return static_cast<uint64_t>(static_cast<double>(least) *
                                 std::pow(static_cast<double>(most + 1) / least, Unit()));
  }
  uint64_t Bits() { return random_ = MixBits(random_); }

 private:
  uint64_t random_;
};

std::string Size(uint64_t bytes) { return bytes == 0 ? "any" : std::to_string(bytes); }

}  // namespace

FaultPlan PlanFaults(uint64_t seed) {
  Draws draw(seed);
  FaultPlan plan;
  plan.seed = seed;
  RunOptions& o = plan.options;
  o.schedule = static_cast<Schedule>(draw.Below(3));
  o.processes = static_cast<uint16_t>(draw.Low(1, 24));
  o.pyramid = static_cast<uint32_t>(draw.Low(1, 1024));
  o.cell_bytes = static_cast<uint32_t>(draw.Low(150, 8000));
  if (draw.Chance(0.6)) o.rays_in_flight = static_cast<uint32_t>(draw.Low(1, 200));
  o.cache = draw.Chance(0.3) ? 0 : draw.Chance(0.4) ? 1 : draw.Low(500, 30000);
  o.resident = draw.Chance(0.4) ? 0 : draw.Low(500, 30000);
  plan.tight_memory = draw.Chance(0.25);
  if (plan.tight_memory) o.rays_in_flight = 0;  // as many as the memory allows

  if (draw.Chance(0.7)) plan.slow_processes = draw.Chance(0.5) ? 0.25 : 0.6;
  plan.slowness_max = static_cast<double>(draw.Low(2, 200));
  const double late = draw.Unit();
  plan.lateness = 20 * late * late * late;
  if (draw.Chance(0.3)) plan.slow_links = 0.3 * draw.Unit();
  if (draw.Chance(0.3)) plan.stalls = 0.05 * draw.Unit();
  plan.works_first = draw.Chance(0.2) ? 0 : draw.Chance(0.2) ? 0.97 : draw.Unit();
  if (draw.Chance(0.4) && ForwardsRays(o.schedule)) o.shadows = Shadows::kTravel;
  return plan;
}

std::string FaultPlan::Text() const {
  return std::string(Name(options.schedule)) +
         (options.shadows == Shadows::kTravel ? ", travelling shadows, " : ", ") +
         std::to_string(options.processes) + " processes, pyramids of " +
         std::to_string(options.pyramid) + ", rays in flight " + Size(options.rays_in_flight) +
         ", cells of " + std::to_string(options.cell_bytes) + " bytes, cache " +
         Size(options.cache) + ", resident " + std::to_string(options.resident) +
         (tight_memory ? ", tight memory" : "");
}

FaultTiming::FaultTiming(const FaultPlan& plan, size_t processes)
    : plan_(plan), random_(MixBits(plan.seed ^ 0x7e57u)), link_key_(MixBits(random_)) {
  for (size_t i = 0; i < processes; ++i) {
    const bool slow = Draw() < plan_.slow_processes;
    slowness_.push_back(slow ? 1 + (plan_.slowness_max - 1) * Draw() * Draw() : 1);
  }
}

double FaultTiming::Draw() {
  random_ = MixBits(random_);
  return UnitOf(random_);
}

double FaultTiming::StepSeconds(ProcessId process, const WorkDone&) {
  const double stall = plan_.stalls > 0 && Draw() < plan_.stalls ? 100 : 1;
  return slowness_[process] * stall * (0.01 + Draw());
}

double FaultTiming::ArrivalTime(ProcessId from, ProcessId to, size_t, double now) {
  const uint64_t link = uint64_t{from} << 16 | to;
  const bool slow = UnitOf(MixBits(link_key_ ^ link)) < plan_.slow_links;
  return now + (slow ? 100 : 1) * plan_.lateness * -std::log(1 - Draw());
}

}  // namespace rayshade::parallel
