// The simulator around processes that write down what they send; see recorded_run.h.
#include "tests/support/recorded_run.h"

#include <algorithm>
#include <stdexcept>

#include "parallel/host_process.h"
#include "parallel/object_spool.h"
#include "parallel/sim/fault_plan.h"
#include "parallel/sim/simulator.h"
#include "parallel/trace_process.h"
#include "tests/support/parallel_run.h"

namespace rayshade::parallel {

namespace {

class RecordedProcess : public Process {
 public:
  RecordedProcess(ProcessId id, Process* process, std::vector<SentMessage>* sent)
      : id_(id), process_(process), sent_(sent) {}

  void Receive(ProcessId from, std::span<const uint8_t> message, Outbox* outbox) override {
    Recorder recorder(id_, sent_, outbox);
    process_->Receive(from, message, &recorder);
  }
  bool Work(Outbox* outbox) override {
    Recorder recorder(id_, sent_, outbox);
    return process_->Work(&recorder);
  }
  bool finished() const override { return process_->finished(); }

 private:
  class Recorder : public Outbox {
   public:
    Recorder(ProcessId from, std::vector<SentMessage>* sent, Outbox* to)
        : record_(from, sent), to_(to) {}
    void Send(ProcessId to, std::vector<uint8_t> bytes) override {
      record_.Send(to, bytes);
      to_->Send(to, std::move(bytes));
    }

   private:
    RecordingOutbox record_;
    Outbox* to_;
  };

  ProcessId id_;
  Process* process_;
  std::vector<SentMessage>* sent_;
};

}  // namespace

size_t RecordedRun::Count(Tag tag) const {
  return static_cast<size_t>(
      std::count_if(sent.begin(), sent.end(), [tag](const auto& s) { return s.tag == tag; }));
}

std::vector<Traveller> RecordedRun::Travellers(const SentMessage& message) const {
  std::vector<Traveller> list;
  const auto add = [&](const TravellingRays& rays) {
    for (const PrimaryTravel& p : rays.primary) {
      Travel travel;
      travel.back = {kHost, p.token};
      travel.resume = p.resume;
      travel.best_distance = p.best_distance;
      travel.best_rank = p.best_rank;
      list.push_back({camera->PrimaryRay(SampleOf(p.token)), travel});
    }
    for (size_t i = 0; i < rays.travel.size(); ++i)
      list.push_back({rays.bundle.rays[i], rays.travel[i]});
  };
  if (message.tag == Tag::kRayTask) add(Decode<RayTask>(message.bytes));
  if (message.tag == Tag::kIntersectionTask) add(Decode<IntersectionTask>(message.bytes));
  return list;
}

std::vector<Pixel> RecordedRun::Pixels(const SentMessage& message) {
  std::vector<Pixel> pixels;
  if (message.tag != Tag::kPixelResults) return pixels;
  const PixelResults results = Decode<PixelResults>(message.bytes);
  for (uint64_t token : results.voids.tokens()) pixels.push_back({token, {}, false});
  for (const PixelItem& miss : results.misses) pixels.push_back({miss.token, miss.color, false});
  for (const PixelItem& hit : results.hits) pixels.push_back({hit.token, hit.color, true});
  return pixels;
}

ProcessId RecordedRun::OwnerAt(const Ray& ray, double distance) const {
  const CellId cell = tree.At(ray.origin + distance * ray.direction);
  return cell == kNoCell ? kHost : tree.cell(cell).owner;
}

RecordedRun RecordRun(const std::string& text, const RunOptions& options, uint64_t seed) {
  ObjectSpool spool;
  ParseText(text, &spool);
  spool.Place(0);
  HostProcess host(options, &spool, 0);
  const Meter meter;
  RecordedRun run;
  std::vector<std::unique_ptr<Process>> owned;
  std::vector<Process*> processes;
  const auto add = [&](Process* process) {
    const ProcessId id = static_cast<ProcessId>(processes.size());
    owned.push_back(std::make_unique<RecordedProcess>(id, process, &run.sent));
    processes.push_back(owned.back().get());
  };
  add(&host);
  for (int i = 0; i < options.processes; ++i) {
    TraceProcess* trace = new TraceProcess(&meter);
    add(trace);
    owned.emplace_back(trace);
  }
  FaultTiming timing(PlanFaults(seed), processes.size());  // for its times
  Simulator(processes, &timing).Run();
  if (host.phase() != HostProcess::Phase::kDone) throw std::runtime_error(host.failure());
  run.tree = host.tree();
  run.camera = std::make_unique<Camera>(spool.scene().settings, 0);
  run.picture = host.sampling().picture();
  run.processes = host.statistics();
  run.in_flight_limit = host.in_flight_limit();
  return run;
}

}  // namespace rayshade::parallel
