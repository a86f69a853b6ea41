// Seeded order of events; see simulator.h.
#include "parallel/sim/simulator.h"

#include <numeric>
#include <stdexcept>

#include "rayshade/common/keyed_random.h"

namespace rayshade::parallel {

class Simulator::SimulatedOutbox : public Outbox {
 public:
  SimulatedOutbox(Simulator* simulator, ProcessId from) : simulator_(simulator), from_(from) {}

  void Send(ProcessId to, std::vector<uint8_t> bytes) override {
    Simulator& s = *simulator_;
    const size_t tag = static_cast<size_t>(TagOf(bytes));
    ++s.messages_[tag];
    s.bytes_[tag] += bytes.size();
    const size_t number = from_ * s.processes_.size() + to;
    Link& link = s.links_.at(number);
    if (link.messages.empty()) s.busy_links_.push_back(number);
    link.messages.push_back(std::move(bytes));
  }

 private:
  Simulator* simulator_;
  ProcessId from_;
};

Simulator::Simulator(std::vector<Process*> processes, uint64_t seed)
    : processes_(std::move(processes)), is_worker_(processes_.size(), 1), random_(MixBits(seed)) {
  const size_t n = processes_.size();
  for (size_t from = 0; from < n; ++from) {
    outboxes_.push_back(std::make_unique<SimulatedOutbox>(this, static_cast<ProcessId>(from)));
    workers_.push_back(static_cast<ProcessId>(from));
    for (size_t to = 0; to < n; ++to) {
      links_.push_back({static_cast<ProcessId>(from), static_cast<ProcessId>(to), {}});
    }
  }
}

Simulator::~Simulator() = default;

size_t Simulator::Draw(size_t below) {
  random_ = MixBits(random_);
  return random_ % below;
}

void Simulator::Deliver(Link* link) {
  const std::vector<uint8_t> bytes = std::move(link->messages.front());
  link->messages.pop_front();
  processes_[link->to]->Receive(link->from, bytes, outboxes_[link->to].get());
  if (!is_worker_[link->to]) {
    is_worker_[link->to] = 1;
    workers_.push_back(link->to);
  }
}

void Simulator::Run() {
  while (!processes_[0]->finished()) {
    const size_t events = busy_links_.size() + workers_.size();
    if (events == 0)
      throw std::runtime_error("the run hangs: no process has work, no message is under way");
    const size_t event = Draw(events);
    if (event < busy_links_.size()) {
      Link* link = &links_[busy_links_[event]];
      if (link->messages.size() == 1) {
        busy_links_[event] = busy_links_.back();
        busy_links_.pop_back();
      }
      Deliver(link);
    } else {
      const size_t w = event - busy_links_.size();
      const ProcessId worker = workers_[w];
      if (processes_[worker]->Work(outboxes_[worker].get())) continue;
      workers_[w] = workers_.back();
      workers_.pop_back();
      is_worker_[worker] = 0;
    }
  }
}

uint64_t Simulator::messages() const {
  return std::accumulate(messages_, messages_ + kTags, uint64_t{0});
}

}  // namespace rayshade::parallel
