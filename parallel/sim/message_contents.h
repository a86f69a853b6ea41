// What a message carries, as the simulator's observers see it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "parallel/message.h"

namespace rayshade::parallel {

// The return addresses of the rays, hits and results in a message; none of other messages.
struct RaysOfMessage {
  std::vector<ReturnAddress> travelling;  // rays and hits
  std::vector<ReturnAddress> finished;    // results; the process is the receiver
  size_t size() const { return travelling.size() + finished.size(); }

  // Of shadow rays, beside these: the hits that wait for them are counted where they wait.
  std::vector<ReturnAddress> shadows_travelling, shadows_finished;
};
RaysOfMessage RaysOf(std::span<const uint8_t> message, ProcessId to);

// For people: "64 primary rays", "3 objects".
std::string ContentsOf(std::span<const uint8_t> message);

}  // namespace rayshade::parallel
