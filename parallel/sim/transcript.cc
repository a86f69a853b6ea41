// See transcript.h.
#include "parallel/sim/transcript.h"

#include <cstdio>

#include "parallel/sim/message_contents.h"

namespace rayshade::parallel {

namespace {

std::string ProcessName(ProcessId process) {
  return process == kHost ? "host" : std::to_string(process);
}

}  // namespace

void Transcript::Headline(const std::string& text) { *out_ << "# " << text << "\n"; }

void Transcript::OnDepart(const SimulatedMessage& message, double departs, double arrives) {
  char line[200];
  std::snprintf(line, sizeof line, "%14.6f %14.6f  %4s -> %-4s  %-16s %8zu bytes  ", departs,
                arrives, ProcessName(message.from).c_str(), ProcessName(message.to).c_str(),
                NameOf(TagOf(message.bytes)), message.bytes.size());
  std::string text = line + ContentsOf(message.bytes);
  text.erase(text.find_last_not_of(' ') + 1);
  *out_ << text << "\n";
}

}  // namespace rayshade::parallel
