// The virtual machine that a run uses: the user's where one is running, else one of our own on this
// host, which ends with the run. Whatever the run started is gone when this object is.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "parallel/pvm/private_pvmd.h"

namespace rayshade::parallel {

struct PvmHost {
  int tid = 0;  // of its pvmd
  std::string name;
  int speed = 1000;  // relative: sp= of the hostfile
};

// A trace process that was started.
struct Spawned {
  int tid = 0;
  std::string machine;
  bool local = true;  // on this host: its end is noticed at once
};

// How many of so many processes each host gets, in proportion to speed; the first hosts get more.
std::vector<int> Shares(const std::vector<PvmHost>& hosts, int processes);

class VirtualMachine {
 public:
  // Throws std::runtime_error where PVM is not installed or does not start.
  VirtualMachine();
  ~VirtualMachine();

  const std::vector<PvmHost>& hosts() const { return hosts_; }
  bool one_format() const { return one_format_; }

  // Starts so many trace processes, spread over the hosts. Throws naming both numbers where fewer
  // start; those are ended again.
  std::vector<Spawned> SpawnTraceProcesses(int processes);
  // One of them is known to have ended.
  void Forget(int tid);

 private:
  void Join();
  void SpawnOn(const PvmHost& host, int count, const std::string& program, int* error);
  void KillSpawned();

  std::unique_ptr<PrivatePvmd> own_;
  std::vector<PvmHost> hosts_;
  bool one_format_ = true;
  int self_host_ = 0;
  std::vector<Spawned> spawned_;
};

}  // namespace rayshade::parallel
