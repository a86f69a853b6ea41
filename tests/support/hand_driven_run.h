// The processes of a run with a test in place of the transport: it carries messages one by one,
// answers in a process's place, and says what nobody should say.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "parallel/host_process.h"
#include "parallel/message.h"
#include "parallel/object_spool.h"
#include "parallel/trace_process.h"
#include "tests/support/parallel_run.h"
#include "tests/support/recorded_run.h"

namespace rayshade::parallel {

class HandDrivenRun {
 public:
  HandDrivenRun(const std::string& text, const RunOptions& options) {
    ParseText(text, &spool_);
    spool_.Place(0);
    host = std::make_unique<HostProcess>(options, &spool_, 0);
    for (int i = 0; i < options.processes; ++i)
      trace.push_back(std::make_unique<TraceProcess>(&meter_));
  }

  Process& process(ProcessId id) {
    return id == kHost ? static_cast<Process&>(*host) : static_cast<Process&>(*trace.at(id - 1));
  }

  // Hands one message over; returns what the receiver sends at once.
  std::vector<SentMessage> Tell(ProcessId from, ProcessId to, std::span<const uint8_t> bytes) {
    std::vector<SentMessage> sent;
    RecordingOutbox outbox(to, &sent);
    process(to).Receive(from, bytes, &outbox);
    return sent;
  }
  template <class Message>
  std::vector<SentMessage> Tell(ProcessId from, ProcessId to, const Message& message) {
    return Tell(from, to, std::span<const uint8_t>(Encode(message)));
  }
  std::vector<SentMessage> Tell(const SentMessage& s) {
    return Tell(s.from, s.to, std::span<const uint8_t>(s.bytes));
  }
  // Lets a process work until it has nothing to do; returns what it sends.
  std::vector<SentMessage> Work(ProcessId id) {
    std::vector<SentMessage> sent;
    RecordingOutbox outbox(id, &sent);
    while (process(id).Work(&outbox)) {
    }
    return sent;
  }

  // Carries messages until all objects are distributed: the host is about to hand out rays.
  void SetUpAll() {
    std::deque<SentMessage> under_way;
    const auto add = [&](const std::vector<SentMessage>& sent) {
      under_way.insert(under_way.end(), sent.begin(), sent.end());
    };
    while (host->phase() != HostProcess::Phase::kTrace && !host->finished()) {
      if (under_way.empty()) {
        std::vector<SentMessage> sent;
        RecordingOutbox outbox(kHost, &sent);
        if (!host->Work(&outbox)) return;
        add(sent);
        continue;
      }
      const SentMessage message = std::move(under_way.front());
      under_way.pop_front();
      add(Tell(message));
    }
  }

  std::unique_ptr<HostProcess> host;
  std::vector<std::unique_ptr<TraceProcess>> trace;

 private:
  ObjectSpool spool_;
  Meter meter_;
};

}  // namespace rayshade::parallel
