// Messages between the processes of a run over PVM: an Outbox, and the way back in.
//
//   1. One message of the catalogue is one PVM message of one byte array, sent by the direct route
//      in fragments of 64 kB. PVM keeps the order of one sender to one receiver.
//   2. Beneath the catalogue lie the transport's own messages: Start (who is who, and which frame),
//      Pulse (a trace process lives), Leave (the run is over), and PVM's notice that a task is
//      gone.
//   3. A run has a context of its own, and a frame its own tags: what comes from anyone else, or
//      from an earlier frame, is dropped.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "parallel/message.h"
#include "parallel/process.h"

namespace rayshade::parallel {

// What has come in.
struct Arrival {
  enum class Kind {
    kNone,     // nothing within the time
    kMessage,  // of the catalogue
    kStart,    // to a trace process: a frame begins
    kPulse,    // to the host
    kLeave,    // to a trace process: the run is over
    kGone,     // a task has ended: `from`
  };
  Kind kind = Kind::kNone;
  ProcessId from = kHost;
  std::vector<uint8_t> bytes;  // of a message; reused from one arrival to the next
};

class PvmTransport : public Outbox {
 public:
  // The host's end. tids: of the processes 1 … n. raw: all PVM hosts have one data format.
  PvmTransport(std::vector<int> tids, bool raw);
  // A trace process's end; knows its host only, until Start arrives.
  explicit PvmTransport(int host_tid);

  // Host: begins the next frame at every trace process.
  void StartFrame();
  // Host: the run is over for them.
  void SendLeave();
  // Trace process: a sign of life.
  void SendPulse();

  void Send(ProcessId to, std::vector<uint8_t> bytes) override;
  // Takes in the next arrival, waiting at most so long; seconds 0: only what is there already.
  // Throws PvmError where pvmd is gone, WireError for a Start that is not ours.
  void Receive(double seconds, Arrival* arrival);

  ProcessId self() const { return self_; }
  // Messages of the catalogue that were sent in this frame, by tag.
  const std::array<KindCount, kTags>& sent() const { return sent_; }

 private:
  void Enter();
  void ForgetSent();
  // False: dropped.
  bool Open(int buffer, Arrival* arrival);
  void ReadStart();
  void ReadBytes(int length, std::vector<uint8_t>* bytes);
  void AskToBeToldOf(const std::vector<int>& tids);

  ProcessId self_ = kHost;
  std::vector<int> tids_;  // [0] is the host
  std::unordered_map<int, ProcessId> ids_;
  bool raw_ = false;
  int frame_ = 0;  // counted from 1; 0: none has begun
  std::deque<std::vector<uint8_t>> to_self_;
  std::array<KindCount, kTags> sent_;
};

}  // namespace rayshade::parallel
