// What Rayshade has to say about an object that cannot be made as it was written [rayshade4/2 s.6,
// s.13].
#pragma once

#include <optional>
#include <string>

#include "rayshade/common/diagnostics.h"

namespace rayshade {

struct Complaint {
  Severity severity = Severity::kWarn;
  std::string text;     // Rayshade's own words, such as "Degenerate sphere."
  bool dropped = true;  // the object cannot be made
};

inline std::optional<Complaint> Refuse(const char* text, Severity severity = Severity::kWarn) {
  return Complaint{severity, text, true};
}

}  // namespace rayshade
