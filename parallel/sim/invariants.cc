// See invariants.h.
#include "parallel/sim/invariants.h"

#include "parallel/sim/message_contents.h"
#include "parallel/work_queue.h"

namespace rayshade::parallel {

namespace {

[[noreturn]] void Broken(const std::string& what) { throw BrokenInvariant("invariant: " + what); }

std::string NameOfProcess(ProcessId process) {
  return process == kHost ? "the host" : "process " + std::to_string(process);
}

std::string NameOfRay(const ReturnAddress& back) {
  return (back.process == kHost ? "primary ray "
                                : "ray for " + NameOfProcess(back.process) + ", token ") +
         std::to_string(back.token);
}

std::string NameOfMessage(const SimulatedMessage& m) {
  return std::string(NameOf(TagOf(m.bytes))) + " from " + NameOfProcess(m.from) + " to " +
         NameOfProcess(m.to);
}

}  // namespace

Invariants::Invariants(const RunOptions& options, const RunProcesses* processes,
                       const Simulator* simulator)
    : options_(options),
      processes_(processes),
      simulator_(simulator),
      in_processes_(processes->all.size()),
      work_requests_(processes->all.size()),
      cells_(processes->all.size()),
      stopped_(processes->all.size()) {}

// A ray or hit goes on: from its spawner for the first time, or from where it is.
void Invariants::Leave(const ReturnAddress& back, const SimulatedMessage& message) {
  const auto key = std::make_pair(back.process, back.token);
  const auto it = rays_.find(key);
  if (message.from == back.process) {
    if (it != rays_.end()) Broken(NameOfRay(back) + " is there twice: " + NameOfMessage(message));
    rays_.emplace(key, Place{message.to, true});
    return;
  }
  if (it == rays_.end() || it->second.process != message.from || it->second.under_way)
    Broken(NameOfRay(back) + " is not with its sender: " + NameOfMessage(message));
  it->second = {message.to, true};
}

void Invariants::Come(const ReturnAddress& back, const SimulatedMessage& message) {
  const auto it = rays_.find({back.process, back.token});
  if (it == rays_.end() || !it->second.under_way) Broken(NameOfRay(back) + " comes unsent");
  it->second.under_way = false;
  if (message.to == back.process) rays_.erase(it);  // at home again
}

void Invariants::Answer(const ReturnAddress& back, const SimulatedMessage& message) {
  const auto it = rays_.find({back.process, back.token});
  if (it == rays_.end() || it->second.process != message.from || it->second.under_way)
    Broken(NameOfRay(back) + " is answered twice or by a stranger: " + NameOfMessage(message));
  rays_.erase(it);
}

// A shadow ray is followed at its spawner as well, where it may come by again.
void Invariants::ShadowLeaves(const ReturnAddress& back, const SimulatedMessage& message) {
  const auto key = std::make_pair(back.process, back.token);
  const auto it = shadows_.find(key);
  if (it == shadows_.end() && message.from == back.process) {
    shadows_.emplace(key, Place{message.to, true});
    return;
  }
  if (it == shadows_.end() || it->second.process != message.from || it->second.under_way)
    Broken("shadow " + NameOfRay(back) + " is not with its sender: " + NameOfMessage(message));
  it->second = {message.to, true};
}

void Invariants::ShadowComes(const ReturnAddress& back, const SimulatedMessage& message) {
  const auto it = shadows_.find({back.process, back.token});
  if (it == shadows_.end() || !it->second.under_way || it->second.process != message.to)
    Broken("shadow " + NameOfRay(back) + " comes unsent");
  it->second.under_way = false;
}

void Invariants::ShadowIsAnswered(const ReturnAddress& back, const SimulatedMessage& message) {
  const auto it = shadows_.find({back.process, back.token});
  if (it == shadows_.end() || it->second.process != message.from || it->second.under_way) {
    Broken("shadow " + NameOfRay(back) +
           " is answered twice or by a stranger: " + NameOfMessage(message));
  }
  shadows_.erase(it);
}

void Invariants::CheckSilence(const SimulatedMessage& message) const {
  if (stopped_[message.from]) Broken(NameOfMessage(message) + ", which had stopped");
  if (message.from == kHost && TagOf(message.bytes) != Tag::kStop &&
      processes_->host.phase() == HostProcess::Phase::kStop) {
    Broken(NameOfMessage(message) + " after the end");
  }
  if (stopped_[message.to]) Broken(NameOfMessage(message) + ", which has stopped");
}

void Invariants::OnSend(const SimulatedMessage& message) {
  CheckSilence(message);
  const RaysOfMessage rays = RaysOf(message.bytes, message.to);
  for (const ReturnAddress& back : rays.travelling) Leave(back, message);
  for (const ReturnAddress& back : rays.finished) Answer(back, message);
  for (const ReturnAddress& back : rays.shadows_travelling) ShadowLeaves(back, message);
  for (const ReturnAddress& back : rays.shadows_finished) ShadowIsAnswered(back, message);
  in_messages_ += rays.size();
  switch (TagOf(message.bytes)) {
    case Tag::kWorkRequest:
      if (++work_requests_[message.from] > kRequestsAhead)
        Broken(NameOfProcess(message.from) + " asks for more work than it may");
      break;
    case Tag::kPrimaryRays:
      if (--work_requests_[message.to] < 0)
        Broken(NameOfMessage(message) + ", which has not asked");
      break;
    case Tag::kCellRequest:
      if (!cell_requests_.emplace(message.from, message.to, Decode<CellRequest>(message.bytes).cell)
               .second) {
        Broken("a cell is asked for twice: " + NameOfMessage(message));
      }
      if (++cells_[message.from] > static_cast<int>(kCellsAhead))
        Broken(NameOfProcess(message.from) + " asks for more cells than it may");
      break;
    case Tag::kCellReply:
      if (cell_requests_.erase({message.to, message.from, Decode<CellReply>(message.bytes).cell}) ==
          0)
        Broken("a cell that was not asked for: " + NameOfMessage(message));
      break;
    case Tag::kStatistics:
      stopped_[message.from] = true;
      break;
    default:
      break;
  }
}

void Invariants::OnTake(const SimulatedMessage& message) {
  const RaysOfMessage rays = RaysOf(message.bytes, message.to);
  for (const ReturnAddress& back : rays.travelling) Come(back, message);
  for (const ReturnAddress& back : rays.shadows_travelling) ShadowComes(back, message);
  in_messages_ -= rays.size();
  if (TagOf(message.bytes) == Tag::kCellReply) --cells_[message.to];
}

void Invariants::OnStep(ProcessId process, double, double, size_t) {
  if (process != kHost) {
    const TraceProcess& trace = *processes_->trace[process - 1u];
    in_all_processes_ += trace.rays_in_work() - in_processes_[process];
    in_processes_[process] = trace.rays_in_work();
    // Whether the objects fit is found out when they are there; only then is tracing begun.
    const bool traces = processes_->host.phase() == HostProcess::Phase::kTrace;
    if (traces && options_.memory != 0 && trace.bytes_held() > options_.memory) {
      Broken(NameOfProcess(process) + " holds " + std::to_string(trace.bytes_held()) +
             " bytes, its budget is " + std::to_string(options_.memory));
    }
  }
  const uint64_t in_flight = processes_->host.in_flight();
  if (in_flight > processes_->host.in_flight_limit())
    Broken(std::to_string(in_flight) + " primary rays are in flight");
  const size_t unsent = processes_->host.unsent();
  if (in_flight != unsent + in_messages_ + in_all_processes_) {
    Broken(std::to_string(in_flight) + " primary rays are in flight; rays in the host: " +
           std::to_string(unsent) + ", in messages: " + std::to_string(in_messages_) +
           ", in processes: " + std::to_string(in_all_processes_));
  }
}

void Invariants::OnEvent() {
  for (size_t i = 0; i < processes_->all.size(); ++i) {
    if (simulator_->idles(static_cast<ProcessId>(i)))
      Broken(NameOfProcess(static_cast<ProcessId>(i)) + " is idle while it has work");
  }
}

void Invariants::AtEnd() const {
  if (!rays_.empty())
    Broken(NameOfRay({rays_.begin()->first.first, rays_.begin()->first.second}) + " is left over");
  if (!shadows_.empty()) {
    const auto& [process, token] = shadows_.begin()->first;
    Broken("shadow " + NameOfRay({process, token}) + " is left over");
  }
  if (!cell_requests_.empty()) Broken("a cell that nobody sent");
  for (size_t i = 1; i < processes_->all.size(); ++i) {
    if (!processes_->all[i]->finished())
      Broken(NameOfProcess(static_cast<ProcessId>(i)) + " does not stop");
  }
}

}  // namespace rayshade::parallel
