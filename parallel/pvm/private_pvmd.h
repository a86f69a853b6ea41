// A pvmd of our own on this host, for a run that finds no virtual machine. It has a folder of its
// own (PVM_TMP), and a name of its own (PVM_VMID) unless the user gave one, so that it meets no
// other.
//
// A guardian process stands between: it starts the pvmd, holds one end of a pipe, and when the
// other end closes, for whatever reason, ends the pvmd and all tasks and removes the folder. So
// nothing is left, even where this process is killed.
#pragma once

#include <sys/types.h>

#include <string>

namespace rayshade::parallel {

// What PVM needs in the environment before its first call: PVM_ROOT (default /usr/lib/pvm3), and
// PVM_ALLOW_ROOT for root.
void PreparePvmEnvironment();

// Whether a pvmd answers at the place where libpvm would look for it.
bool PvmdRuns();

class PrivatePvmd {
 public:
  // Sets PVM_VMID and PVM_TMP of this process. Throws std::runtime_error where PVM is not installed
  // or does not start.
  PrivatePvmd();
  ~PrivatePvmd() { End(); }
  PrivatePvmd(const PrivatePvmd&) = delete;
  PrivatePvmd& operator=(const PrivatePvmd&) = delete;

  // Returns when the pvmd, its tasks and its folder are gone.
  void End();

 private:
  void StartGuardian(const std::string& pvmd);
  void AwaitPvmd();

  std::string folder_;
  pid_t guardian_ = -1;
  int life_ = -1;    // our end of the pipe
  int status_ = -1;  // closes when the pvmd has ended
};

}  // namespace rayshade::parallel
