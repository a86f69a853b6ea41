// The process that watches over a pvmd of our own; see private_pvmd.h.
#pragma once

#include <string>

namespace rayshade::parallel {

// In a freshly forked process: starts the pvmd and waits until the reading end `life` reports that
// the other end is closed; then ends the pvmd and whatever it has started, removes the folder and
// exits. `status` is closed when the pvmd has ended.
[[noreturn]] void Guard(const std::string& pvmd, const std::string& folder, int life, int status);

}  // namespace rayshade::parallel
