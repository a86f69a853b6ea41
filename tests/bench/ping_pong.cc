// ping_pong: what a message costs between two processes on this host by the project's own
// transport, as lines "NAME SECONDS" of a machine (parallel/sim/machine.h). Run it in a virtual
// machine: pvm_conf/private-vm build/ping_pong. It spawns itself as the other side.
//
//   step                       looking for messages where there is none
//   send + bytes x send_byte         handing a message to PVM
//   receive + bytes x receive_byte   taking in a message that is there
//   local_latency + bytes x local_gap   what is left of the way to and fro
#include <pvm3.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <vector>

#include "parallel/pvm/private_pvmd.h"
#include "parallel/pvm/pvm_call.h"
#include "parallel/pvm/pvm_transport.h"

namespace rayshade::parallel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kRays[] = {1, 30, 120};  // 200 bytes, one fragment of pvmd, a full pack
constexpr int kRounds = 2000;
constexpr int kAtOnce = 20;

double Since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

RayTask Task(size_t rays) {
  RayTask task;
  for (size_t i = 0; i < rays; ++i) {
    Ray ray;
    ray.kind = RayKind::kReflected;
    task.bundle.rays.push_back(ray);
    task.travel.push_back({});
  }
  return task;
}

void Await(PvmTransport* transport, Arrival* arrival) {
  do {
    transport->Receive(1, arrival);
  } while (arrival->kind != Arrival::Kind::kMessage && arrival->kind != Arrival::Kind::kLeave);
}

// The other side: answers every RayTask by itself; at a WorkRequest sends kAtOnce of the last one.
void Pong() {
  PvmTransport transport(PvmCheck(pvm_parent(), "pvm_parent"));
  Arrival arrival;
  do {
    transport.Receive(1, &arrival);
  } while (arrival.kind != Arrival::Kind::kStart);
  std::vector<uint8_t> task;
  while (true) {
    Await(&transport, &arrival);
    if (arrival.kind == Arrival::Kind::kLeave) return;
    if (TagOf(arrival.bytes) == Tag::kRayTask) {
      task = arrival.bytes;
      transport.Send(kHost, task);
    } else {
      for (int i = 0; i < kAtOnce; ++i) transport.Send(kHost, task);
      transport.Send(kHost, Encode(WorkRequest{}));
    }
  }
}

// Seconds for a message of each size, and its bytes.
struct Cost {
  double bytes = 0, round_trip = 0, send = 0, receive = 0;
};

Cost Measure(PvmTransport* transport, size_t rays) {
  const RayTask task = Task(rays);
  Cost cost;
  cost.bytes = static_cast<double>(Encode(task).size());
  Arrival arrival;
  std::vector<double> trips, sends, receives;
  for (int i = 0; i < kRounds; ++i) {
    std::vector<uint8_t> bytes = Encode(task);
    const Clock::time_point begin = Clock::now();
    transport->Send(1, std::move(bytes));
    const double sent = Since(begin);
    Await(transport, &arrival);
    if (i < kRounds / 10) continue;  // the route is being made
    trips.push_back(Since(begin));
    sends.push_back(sent);
  }
  // Messages that are there already: they are taken in until none is.
  for (int i = 0; i < kRounds / kAtOnce; ++i) {
    transport->Send(1, Encode(WorkRequest{}));
    usleep(2000);
    for (int k = 0; k < kAtOnce; ++k) {
      const Clock::time_point begin = Clock::now();
      transport->Receive(0, &arrival);
      if (arrival.kind != Arrival::Kind::kMessage) break;
      receives.push_back(Since(begin));
    }
    while (arrival.kind != Arrival::Kind::kMessage || TagOf(arrival.bytes) != Tag::kWorkRequest)
      transport->Receive(1, &arrival);
  }
  cost.round_trip = Median(trips);
  cost.send = Median(sends);
  cost.receive = Median(receives);
  return cost;
}

double EmptyLook(PvmTransport* transport) {
  Arrival arrival;
  std::vector<double> looks;
  for (int i = 0; i < kRounds; ++i) {
    const Clock::time_point begin = Clock::now();
    transport->Receive(0, &arrival);
    looks.push_back(Since(begin));
  }
  return Median(looks);
}

// The line through the first and the last: a + bytes x b, neither negative.
void PrintLine(const char* a, const char* b, const std::vector<Cost>& costs, auto seconds) {
  const Cost &first = costs.front(), &last = costs.back();
  const double slope = std::max(0.0, (seconds(last) - seconds(first)) / (last.bytes - first.bytes));
  std::printf("%s %.4g\n%s %.4g\n", a, std::max(0.0, seconds(first) - slope * first.bytes), b,
              slope);
}

int Ping() {
  char self[4096];
  const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
  if (length <= 0) throw std::runtime_error("/proc/self/exe cannot be read");
  self[length] = 0;
  char word[] = "pong";
  char* arguments[] = {word, nullptr};
  int tid = 0;
  if (pvm_spawn(self, arguments, PvmTaskDefault, nullptr, 1, &tid) != 1)
    throw std::runtime_error("pvm_spawn(" + std::string(self) + "): " + PvmErrorText(tid));
  PvmTransport transport({tid}, /*raw=*/true);
  transport.StartFrame();
  std::printf("step %.4g\n", EmptyLook(&transport));
  std::vector<Cost> costs;
  for (const size_t rays : kRays) costs.push_back(Measure(&transport, rays));
  transport.SendLeave();
  for (const Cost& c : costs)
    std::fprintf(stderr, "%6.0f bytes: round trip %.2f us, send %.2f us, receive %.2f us\n",
                 c.bytes, 1e6 * c.round_trip, 1e6 * c.send, 1e6 * c.receive);
  PrintLine("send", "send_byte", costs, [](const Cost& c) { return c.send; });
  PrintLine("receive", "receive_byte", costs, [](const Cost& c) { return c.receive; });
  PrintLine("local_latency", "local_gap", costs,
            [](const Cost& c) { return std::max(0.0, c.round_trip / 2 - c.send - c.receive); });
  return 0;
}

}  // namespace
}  // namespace rayshade::parallel

int main(int argc, char** argv) {
  using namespace rayshade::parallel;
  PreparePvmEnvironment();
  pvm_setopt(PvmAutoErr, 0);
  int status = 0;
  try {
    if (argc > 1 && std::strcmp(argv[1], "pong") == 0) {
      Pong();
    } else {
      status = Ping();
    }
  } catch (const std::exception& e) {
    std::fprintf(stderr, "ping_pong: %s\n", e.what());
    status = 1;
  }
  pvm_exit();
  return status;
}
