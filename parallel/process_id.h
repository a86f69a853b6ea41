// Who is who in a run: the host is process 0, trace processes are 1 … n.
#pragma once

#include <cstdint>

namespace rayshade::parallel {

using ProcessId = uint16_t;
inline constexpr ProcessId kHost = 0;

}  // namespace rayshade::parallel
