// The queue of events; see simulator.h.
#include "parallel/sim/simulator.h"

#include <algorithm>
#include <stdexcept>

#include "parallel/run_report.h"
#include "rayshade/common/check.h"

namespace rayshade::parallel {

class Simulator::SimulatedOutbox : public Outbox {
 public:
  SimulatedOutbox(Simulator* simulator, ProcessId from) : simulator_(simulator), from_(from) {}

  void Send(ProcessId to, std::vector<uint8_t> bytes) override {
    Simulator& s = *simulator_;
    const Tag tag = TagOf(bytes);
    std::array<KindCount, kTags>& sent = s.states_[from_].sent;
    if (tag == Tag::kStatistics) bytes = WithSent(bytes, sent);
    KindCount& count = sent[static_cast<size_t>(tag)];
    if (count.messages == 0) count.name = NameOf(tag);
    ++count.messages;
    count.bytes += bytes.size();
    const uint32_t parcel = s.NewParcel({from_, to, std::move(bytes)});
    s.outgoing_.push_back(parcel);
    s.Tell([&](SimulatorListener* l) { l->OnSend(s.parcels_[parcel]); });
  }

 private:
  Simulator* simulator_;
  ProcessId from_;
};

Simulator::Simulator(std::vector<Process*> processes, Timing* timing,
                     std::vector<SimulatedMeter*> meters)
    : timing_(timing), meters_(std::move(meters)) {
  CHECK(meters_.empty() || meters_.size() == processes.size());
  states_.resize(processes.size());
  for (size_t i = 0; i < processes.size(); ++i) states_[i].process = processes[i];
}

Simulator::~Simulator() = default;

uint32_t Simulator::NewParcel(SimulatedMessage message) {
  CHECK(message.to < states_.size());
  if (free_parcels_.empty()) {
    free_parcels_.push_back(static_cast<uint32_t>(parcels_.size()));
    parcels_.emplace_back();
  }
  const uint32_t parcel = free_parcels_.back();
  free_parcels_.pop_back();
  parcels_[parcel] = std::move(message);
  return parcel;
}

void Simulator::Push(double at, Kind kind, uint32_t which) {
  events_.push({at, sequence_++, kind, which});
}

void Simulator::Depart(uint32_t parcel) {
  const SimulatedMessage& p = parcels_[parcel];
  double& last = last_arrival_[uint32_t{p.from} << 16 | p.to];
  last = std::max(last, timing_->ArrivalTime(p.from, p.to, p.bytes.size(), now_));
  Tell([&](SimulatorListener* l) { l->OnDepart(p, now_, last); });
  Push(last, Kind::kArrive, parcel);
}

void Simulator::Arrive(uint32_t parcel) {
  const ProcessId to = parcels_[parcel].to;
  State& state = states_[to];
  state.inbox.push_back(parcel);
  state.inbox_bytes += parcels_[parcel].bytes.size();
  if (!state.busy) Step(to);
}

// Gives the process the first message of its inbox; returns its size.
size_t Simulator::TakeIn(ProcessId id) {
  State& state = states_[id];
  const uint32_t number = state.inbox.front();
  state.inbox.pop_front();
  const SimulatedMessage parcel = std::move(parcels_[number]);
  free_parcels_.push_back(number);
  state.inbox_bytes -= parcel.bytes.size();
  Tell([&](SimulatorListener* l) { l->OnTake(parcel); });
  SimulatedOutbox outbox(this, id);
  state.process->Receive(parcel.from, parcel.bytes, &outbox);
  state.may_work = true;
  return parcel.bytes.size();
}

void Simulator::Step(ProcessId id) {
  State& state = states_[id];
  state.busy = false;
  if (state.process->finished()) return;
  size_t taken = 0;
  bool made = true;
  if (!state.inbox.empty() && !(state.may_work && timing_->WorksFirst(id))) {
    taken = TakeIn(id);
  } else if (state.may_work) {
    SimulatedOutbox outbox(this, id);
    state.may_work = state.process->Work(&outbox);
    made = state.may_work || !outgoing_.empty() || !state.inbox.empty();
  } else {
    made = false;
  }
  state.busy = made;
  if (!made) return;

  const WorkDone done = state.process->work_done();
  WorkDone work = done;
  work -= state.done;
  state.done = done;
  double seconds = timing_->StepSeconds(id, work);
  if (taken > 0) seconds += timing_->ReceiveSeconds(taken);
  departures_.clear();  // each message leaves when it is sent, in seconds since the step began
  for (const uint32_t parcel : outgoing_) {
    seconds += timing_->SendSeconds(parcels_[parcel].bytes.size());
    departures_.push_back(seconds);
  }
  const double end = timing_->FreeAt(id, seconds, now_);
  const double stretch = seconds > 0 ? (end - now_) / seconds : 1;
  for (size_t i = 0; i < outgoing_.size(); ++i)
    Push(now_ + stretch * departures_[i], Kind::kDepart, outgoing_[i]);
  outgoing_.clear();
  Push(end, Kind::kFree, id);
  if (!meters_.empty()) {
    meters_[id]->busy.Add(now_, end);
    meters_[id]->bytes_max = std::max(meters_[id]->bytes_max, bytes_held(id));
  }
  Tell([&](SimulatorListener* l) { l->OnStep(id, now_, end, taken); });
}

uint64_t Simulator::bytes_held(ProcessId process) const {
  return states_[process].process->bytes_held() + states_[process].inbox_bytes;
}

bool Simulator::idles(ProcessId process) const {
  const State& state = states_[process];
  return !state.busy && !state.process->finished() && (!state.inbox.empty() || state.may_work);
}

void Simulator::MakeEvent() {
  if (events_made_++ == events_max_) {
    throw std::runtime_error("the run does not end: " + std::to_string(events_max_) +
                             " events were made");
  }
  const Event event = events_.top();
  events_.pop();
  now_ = event.at;
  switch (event.kind) {
    case Kind::kDepart:
      Depart(event.which);
      break;
    case Kind::kArrive:
      Arrive(event.which);
      break;
    case Kind::kFree:
      Step(static_cast<ProcessId>(event.which));
      break;
  }
  Tell([](SimulatorListener* l) { l->OnEvent(); });
}

void Simulator::Run() {
  for (size_t i = 0; i < states_.size(); ++i) Step(static_cast<ProcessId>(i));
  while (!states_[kHost].process->finished()) {
    if (events_.empty())
      throw std::runtime_error("the run hangs: no process has work, no message is under way");
    MakeEvent();
  }
}

void Simulator::Drain() {
  while (!events_.empty()) MakeEvent();
}

uint64_t Simulator::messages(Tag tag) const {
  uint64_t sum = 0;
  for (const State& state : states_) sum += state.sent[static_cast<size_t>(tag)].messages;
  return sum;
}

uint64_t Simulator::bytes(Tag tag) const {
  uint64_t sum = 0;
  for (const State& state : states_) sum += state.sent[static_cast<size_t>(tag)].bytes;
  return sum;
}

uint64_t Simulator::messages() const {
  uint64_t sum = 0;
  for (int tag = 0; tag < kTags; ++tag) sum += messages(static_cast<Tag>(tag));
  return sum;
}

const std::array<KindCount, kTags>& Simulator::sent(ProcessId process) const {
  return states_[process].sent;
}

}  // namespace rayshade::parallel
