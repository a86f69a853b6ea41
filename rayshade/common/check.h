// CHECK: our own mistakes end the program, in every build, with the place and the condition.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace rayshade {

[[noreturn]] inline void CheckFailed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: internal error: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace rayshade

#define CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::rayshade::CheckFailed(#condition, __FILE__, __LINE__))
