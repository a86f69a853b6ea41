// See timing.h.
#include "parallel/sim/timing.h"

#include <algorithm>

#include "rayshade/common/keyed_random.h"

namespace rayshade::parallel {

namespace {

double UnitOf(uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

}  // namespace

double CostOf(const Machine& m, const WorkDone& work) {
  const OpCounts& c = work.counts;
  const auto times = [](double unit, uint64_t n) { return unit * static_cast<double>(n); };
  const double operations =
      times(m.ray, c.total_rays()) + times(m.node_visit, c.node_visits - c.lone_visits) +
      times(m.primitive_test, c.primitive_tests - c.lone_tests) +
      times(m.lone_visit, c.lone_visits) + times(m.lone_test, c.lone_tests) +
      times(m.cell_step, c.cell_steps) + times(m.cell_test, c.cell_tests) +
      times(m.cell_trace, c.cell_traces) + times(m.shade, c.shades) +
      times(m.light_sample, c.light_samples) + times(m.object, work.objects_taken) +
      times(m.fetched_object, work.objects_fetched) + times(m.lent_object, work.objects_lent) +
      times(m.sample, work.samples);
  return m.slowness * m.node_slowness * operations;
}

MachineTiming::MachineTiming(const Machine& machine, size_t processes, uint64_t seed)
    : machine_(machine), random_(MixBits(seed)) {
  out_free_.resize(processes + 1);
  in_free_.resize(processes + 1);
  busy_until_.resize(processes);
  node_processes_.resize(processes + 1);
  for (size_t p = 0; p < processes; ++p) {
    const auto process = static_cast<ProcessId>(p);
    node_processes_[NodeOf(process)].push_back(process);
  }
}

size_t MachineTiming::NodeOf(ProcessId process) const {
  if (process == kHost) return machine_.host_apart != 0 ? out_free_.size() - 1 : 0;
  return static_cast<size_t>((process - 1) / machine_.processors);
}

double MachineTiming::StepSeconds(ProcessId, const WorkDone& work) {
  random_ = MixBits(random_);
  const double besides = machine_.slowness * machine_.node_slowness * machine_.process_ray *
                         static_cast<double>(work.rays_handled);
  return (machine_.step + CostOf(machine_, work) + besides) *
         (1 + machine_.jitter * UnitOf(random_));
}

double MachineTiming::FreeAt(ProcessId process, double seconds, double now) {
  double busy = 1;
  for (const ProcessId other : node_processes_[NodeOf(process)])
    if (other != process && busy_until_[other] > now) ++busy;
  const double shared = std::max(1.0, busy / machine_.processors);
  const double slowed = 1 + machine_.contention * (std::min(busy, machine_.processors) - 1);
  return busy_until_[process] = now + seconds * shared * slowed;
}

double MachineTiming::SendSeconds(size_t bytes) {
  return machine_.send + machine_.pack * static_cast<double>(bytes);
}

double MachineTiming::ReceiveSeconds(size_t bytes) {
  return machine_.receive + machine_.unpack * static_cast<double>(bytes);
}

// Through the sender's port, what all share, and the receiver's port, each in order of departure;
// the bytes flow, so that a message of which nothing stands in the way is there after latency +
// bytes x the largest gap.
double MachineTiming::ArrivalTime(ProcessId from, ProcessId to, size_t bytes, double now) {
  const double n = static_cast<double>(bytes);
  const size_t source = NodeOf(from), target = NodeOf(to);
  if (source == target) return now + machine_.local_latency + n * machine_.local_gap;
  const double out_begin = std::max(now, out_free_[source]);
  const double out_end = out_begin + n * machine_.gap;
  out_free_[source] = out_end;
  double begin = out_begin, end = out_end;
  if (machine_.shared_gap > 0) {
    begin = std::max(begin, shared_free_);
    end = std::max(end, begin + n * machine_.shared_gap);
    shared_free_ = begin + n * machine_.shared_gap;
  }
  const double in_begin = std::max(begin + machine_.latency, in_free_[target]);
  const double in_end = std::max(end + machine_.latency, in_begin + n * machine_.gap);
  in_free_[target] = in_begin + n * machine_.gap;
  return in_end;
}

}  // namespace rayshade::parallel
