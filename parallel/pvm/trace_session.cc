// Runs a trace process; see trace_session.h.
#include "parallel/pvm/trace_session.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "parallel/run_report.h"

namespace rayshade::parallel {

namespace {

constexpr auto kPulse = std::chrono::seconds(1);

}  // namespace

void CountingOutbox::Send(ProcessId to, std::vector<uint8_t> bytes) {
  if (TagOf(bytes) == Tag::kStatistics) bytes = WithSent(bytes, transport_->sent());
  transport_->Send(to, std::move(bytes));
}

TraceSession::TraceSession(int host_tid, Factory factory)
    : transport_(host_tid),
      outbox_(&transport_),
      loop_(&transport_, &outbox_),
      factory_(std::move(factory)) {}

int TraceSession::Run() {
  std::string failure;
  try {
    RunFrames();
    return 0;
  } catch (const std::bad_alloc&) {
    failure = "no memory left";
  } catch (const std::exception& e) {
    failure = e.what();
  }
  try {
    transport_.Send(kHost, Encode(Failure{failure + " (on " + loop_.machine() + ")"}));
  } catch (const std::exception&) {
    // The host is out of reach: it will hear of our end from PVM.
    std::fprintf(stderr, "prayshade-trace: %s\n", failure.c_str());
  }
  return 1;
}

void TraceSession::RunFrames() {
  while (!over_) {
    if (!started_) {
      loop_.Await(std::chrono::duration<double>(kPulse).count(), this);
      Tick();
      continue;
    }
    started_ = false;
    const std::unique_ptr<Process> process = factory_(&loop_);
    loop_.Run(process.get(), this);
  }
}

void TraceSession::OnArrival(const Arrival& arrival) {
  if (arrival.kind == Arrival::Kind::kStart) started_ = true;
  if (arrival.kind == Arrival::Kind::kLeave) over_ = true;
  if (arrival.kind == Arrival::Kind::kGone && arrival.from == kHost) over_ = true;
}

bool TraceSession::Tick() {
  const auto now = std::chrono::steady_clock::now();
  if (Interrupts::Came() != 0) over_ = true;
  if (now - last_pulse_ >= kPulse && !over_) {
    last_pulse_ = now;
    transport_.SendPulse();
  }
  return !over_;
}

}  // namespace rayshade::parallel
