// A run in one address space: the very same processes as over PVM, every message encoded and
// decoded, in an order drawn from a seed. Links keep their order pairwise, as PVM does; nothing
// else is promised. No clock, no thread: one seed, one run.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "parallel/message.h"
#include "parallel/process.h"

namespace rayshade::parallel {

class Simulator {
 public:
  // processes[0] is the host, processes[i] trace process i; not owned.
  Simulator(std::vector<Process*> processes, uint64_t seed);
  ~Simulator();

  // Until the host has finished and nothing is under way. Throws std::runtime_error where no
  // process has work and no message is under way before that: the run hangs.
  void Run();

  uint64_t messages(Tag tag) const { return messages_[static_cast<size_t>(tag)]; }
  uint64_t bytes(Tag tag) const { return bytes_[static_cast<size_t>(tag)]; }
  uint64_t messages() const;

 private:
  class SimulatedOutbox;
  struct Link {
    ProcessId from, to;
    std::deque<std::vector<uint8_t>> messages;
  };
  size_t Draw(size_t below);
  void Deliver(Link* link);

  std::vector<Process*> processes_;
  std::vector<std::unique_ptr<SimulatedOutbox>> outboxes_;
  std::vector<Link> links_;         // from * n + to
  std::vector<size_t> busy_links_;  // that hold messages
  std::vector<ProcessId> workers_;  // that may have work
  std::vector<uint8_t> is_worker_;
  uint64_t random_;
  uint64_t messages_[kTags] = {};
  uint64_t bytes_[kTags] = {};
};

}  // namespace rayshade::parallel
