// step_costs: what the processes of a run do while tracing, and how long that takes on this
// machine in processor time, without PVM: step_costs NAME SCENE PIXELS SCHEDULE PROCESSES. The
// processes run in one address space; each call of Receive and Work is measured. Prints a line for
// each process, NAME-host and NAME-trace1 …, another for those of its steps that fetched or lent
// objects, NAME-fetch1 …, and one for all trace processes before tracing, NAME-build: seconds, then
// what was done as the constants of a machine name it, in the order of kNames. Without arguments:
// the names.
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "parallel/object_spool.h"
#include "parallel/parallel_options.h"
#include "parallel/sim/run_processes.h"
#include "parallel/sim/timing.h"
#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/parse.h"

namespace rayshade::parallel {
namespace {

constexpr char kNames[] =
    "ray node_visit primitive_test lone_visit lone_test cell_step cell_test cell_trace shade "
    "light_sample object fetched_object lent_object sample pack unpack process_ray";

struct Done {
  double seconds = 0;
  WorkDone work;
  uint64_t packed = 0, unpacked = 0;  // bytes
};

// Of this program: what others do on the machine meanwhile is not in it.
double ProcessorSeconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Lets a process work, and adds up: before the run traces, while it traces, and, of these steps,
// those that fetch or lend objects.
class MeasuredProcess : public Process {
 public:
  MeasuredProcess(Process* process, const HostProcess* host, Done* before, Done* tracing,
                  Done* fetching)
      : process_(process), host_(host), before_(before), tracing_(tracing), fetching_(fetching) {}

  void Receive(ProcessId from, std::span<const uint8_t> message, Outbox* outbox) override {
    Measure(outbox, message.size(), [&](Outbox* o) {
      process_->Receive(from, message, o);
      return true;
    });
  }
  bool Work(Outbox* outbox) override {
    return Measure(outbox, 0, [&](Outbox* o) { return process_->Work(o); });
  }
  bool finished() const override { return process_->finished(); }
  WorkDone work_done() const override { return process_->work_done(); }

 private:
  struct CountingOutbox : Outbox {
    explicit CountingOutbox(Outbox* o) : outbox(o) {}
    void Send(ProcessId to, std::vector<uint8_t> bytes) override {
      sent += bytes.size();
      outbox->Send(to, std::move(bytes));
    }
    Outbox* outbox;
    uint64_t sent = 0;
  };

  template <class Call>
  bool Measure(Outbox* outbox, uint64_t received, const Call& call) {
    CountingOutbox counting(outbox);
    const bool traces = host_->phase() == HostProcess::Phase::kTrace;
    const WorkDone before = process_->work_done();
    const double begin = ProcessorSeconds();
    const bool more = call(&counting);
    const double spent = ProcessorSeconds() - begin;
    WorkDone work = process_->work_done();
    work -= before;
    const bool fetches = work.objects_fetched + work.objects_lent > 0;
    Done* done = !traces ? before_ : fetches ? fetching_ : tracing_;
    done->seconds += spent;
    done->work += work;
    done->packed += counting.sent;
    done->unpacked += received;
    return more;
  }

  Process* process_;
  const HostProcess* host_;
  Done* before_;
  Done* tracing_;
  Done* fetching_;
};

void Print(const std::string& name, const Done& done) {
  const OpCounts& c = done.work.counts;
  std::printf("%s %.6f", name.c_str(), done.seconds);
  for (const uint64_t n :
       {c.total_rays(), c.node_visits - c.lone_visits, c.primitive_tests - c.lone_tests,
        c.lone_visits, c.lone_tests, c.cell_steps, c.cell_tests, c.cell_traces, c.shades,
        c.light_samples, done.work.objects_taken, done.work.objects_fetched, done.work.objects_lent,
        done.work.samples, done.packed, done.unpacked, done.work.rays_handled})
    std::printf(" %llu", static_cast<unsigned long long>(n));
  std::printf("\n");
}

int Measure(char** argument) {
  Options options;
  options.program = "step_costs";
  options.input = argument[2];
  options.resolution = {std::atoi(argument[3]), std::atoi(argument[3])};
  Diagnostics diagnostics(options.program);
  ObjectSpool spool;
  if (!ParseScene(options, &diagnostics, &spool)) return 1;
  spool.Place(0);
  options.extra = {{"schedule", argument[4]}, {"processes", argument[5]}, {"memory", "2G"}};
  options.extra.insert(options.extra.end(), {{"resident", "256K"}, {"cache", "256M"}});
  RunProcesses run(DefaultsFor(ParseParallelOptions(options), {1, 2, uint64_t{4} << 30}), &spool,
                   0);

  Done host_build, build;
  std::vector<Done> tracing(run.all.size()), fetching(run.all.size());
  std::vector<std::unique_ptr<MeasuredProcess>> measured;
  std::vector<Process*> all;
  for (size_t i = 0; i < run.all.size(); ++i) {
    measured.push_back(std::make_unique<MeasuredProcess>(
        run.all[i], &run.host, i == kHost ? &host_build : &build, &tracing[i], &fetching[i]));
    all.push_back(measured.back().get());
  }
  MachineTiming timing(FindMachine("cluster-1g"), all.size(), 1);
  Simulator(all, &timing).Run();
  if (!run.host.failure().empty()) throw std::runtime_error(run.host.failure());
  const std::string name = argument[1];
  Print(name + "-host", tracing[kHost]);
  for (size_t i = 1; i < tracing.size(); ++i) {
    Print(name + "-trace" + std::to_string(i), tracing[i]);
    if (fetching[i].seconds > 0) Print(name + "-fetch" + std::to_string(i), fetching[i]);
  }
  Print(name + "-build", build);
  return 0;
}

}  // namespace
}  // namespace rayshade::parallel

int main(int argc, char** argv) {
  if (argc != 6) {
    std::printf("%s\n", rayshade::parallel::kNames);
    return argc == 1 ? 0 : 2;
  }
  try {
    return rayshade::parallel::Measure(argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "step_costs: %s\n", e.what());
    return 1;
  }
}
