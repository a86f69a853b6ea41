// Diagnostics on a stream; see diagnostics.h.
#include "rayshade/common/diagnostics.h"

namespace rayshade {

void Diagnostics::Report(Severity severity, const Place& place, const std::string& text) {
  const char* kind = "Warning";
  switch (severity) {
    case Severity::kAdvise:
      if (quiet_) return;
      [[fallthrough]];
    case Severity::kWarn:
      ++warnings_;
      break;
    case Severity::kError:
      kind = "Error";
      ++errors_;
      if (exit_status_ == 0) exit_status_ = 1;
      break;
    case Severity::kFatal:
      kind = "Fatal error";
      ++errors_;
      if (exit_status_ == 0) exit_status_ = 2;
      break;
  }
  if (place.line > 0) {
    std::fprintf(stream_, "%s: %s: %s, line %d: %s\n", program_.c_str(), kind, place.file.c_str(),
                 place.line, text.c_str());
  } else {
    std::fprintf(stream_, "%s: %s: %s\n", program_.c_str(), kind, text.c_str());
  }
}

void Diagnostics::ReportSyntax(const Place& place, const std::string& text) {
  ++errors_;
  if (exit_status_ == 0) exit_status_ = 1;
  std::fprintf(stream_, "%s: Error: %s: line %d: %s\n", program_.c_str(), place.file.c_str(),
               place.line, text.c_str());
}

}  // namespace rayshade
