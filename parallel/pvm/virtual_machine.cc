// Joining, starting and leaving a virtual machine; see virtual_machine.h.
#include "parallel/pvm/virtual_machine.h"

#include <pvm3.h>  // after cstdio, or it hides pvm_catchout
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "parallel/pvm/pvm_call.h"

namespace rayshade::parallel {

namespace {

constexpr const char* kTraceProgram = "prayshade-trace";
constexpr auto kEndLimit = std::chrono::seconds(2);

// The program of that name beside this one; "" where there is none.
std::string BesideThisProgram(const std::string& name) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return "";
  const std::string beside = self.parent_path() / name;
  return access(beside.c_str(), X_OK) == 0 ? beside : "";
}

}  // namespace

std::vector<int> Shares(const std::vector<PvmHost>& hosts, int processes) {
  std::vector<int> shares(hosts.size(), 0);
  for (int p = 0; p < processes; ++p) {
    // The host that would be the least loaded with one more.
    size_t best = 0;
    for (size_t h = 1; h < hosts.size(); ++h)
      if ((shares[h] + 1.0) * hosts[best].speed < (shares[best] + 1.0) * hosts[h].speed) best = h;
    ++shares[best];
  }
  return shares;
}

VirtualMachine::VirtualMachine() {
  PreparePvmEnvironment();
  if (!PvmdRuns()) own_ = std::make_unique<PrivatePvmd>();
  Join();
}

void VirtualMachine::Join() {
  pvm_setopt(PvmAutoErr, 0);
  PvmCheck(pvm_mytid(), "pvm_mytid");
  // A context of this run's own; what it spawns inherits it.
  PvmCheck(pvm_setcontext(PvmCheck(pvm_newcontext(), "pvm_newcontext")), "pvm_setcontext");

  // What a trace process writes itself, such as a failed CHECK, reaches the user.
  PvmCheck(pvm_catchout(stderr), "pvm_catchout");
  PvmCheck(pvm_setopt(PvmShowTids, 0), "pvm_setopt(PvmShowTids)");

  int count = 0, formats = 0;
  pvmhostinfo* infos = nullptr;
  PvmCheck(pvm_config(&count, &formats, &infos), "pvm_config");
  for (int i = 0; i < count; ++i)
    hosts_.push_back({infos[i].hi_tid, infos[i].hi_name, std::max(1, infos[i].hi_speed)});
  one_format_ = formats == 1;
  self_host_ = PvmCheck(pvm_tidtohost(pvm_mytid()), "pvm_tidtohost");
}

std::vector<Spawned> VirtualMachine::SpawnTraceProcesses(int processes) {
  const std::string beside = BesideThisProgram(kTraceProgram);
  const std::vector<int> shares = Shares(hosts_, processes);
  int error = 0;
  for (size_t h = 0; h < hosts_.size(); ++h) {
    const size_t wanted = spawned_.size() + shares[h];
    if (!beside.empty()) SpawnOn(hosts_[h], shares[h], beside, &error);
    // Another layout over there: PVM's own search path.
    const bool search = beside.empty() || error == PvmNoFile;
    if (spawned_.size() < wanted && search)
      SpawnOn(hosts_[h], static_cast<int>(wanted - spawned_.size()), kTraceProgram, &error);
  }
  const int got = static_cast<int>(spawned_.size());
  if (got < processes) {
    KillSpawned();
    std::string text = "pvm_spawn(" + std::string(kTraceProgram) + "): asked " +
                       std::to_string(processes) + ", got " + std::to_string(got) + ": " +
                       PvmErrorText(error);
    if (error == PvmNoFile)
      text +=
          " (neither beside prayshade nor where PVM looks: $PVM_ROOT/bin/$PVM_ARCH, "
          "$HOME/pvm3/bin/$PVM_ARCH, ep= of the hostfile)";
    throw std::runtime_error(text);
  }
  return spawned_;
}

void VirtualMachine::SpawnOn(const PvmHost& host, int count, const std::string& program,
                             int* error) {
  if (count == 0) return;
  std::vector<int> tids(count, 0);
  std::string name = program, where = host.name;
  const int started =
      pvm_spawn(name.data(), nullptr, PvmTaskHost, where.data(), count, tids.data());
  if (started < 0) *error = started;
  for (int i = 0; started >= 0 && i < count; ++i) {
    if (tids[i] > 0) {
      spawned_.push_back({tids[i], host.name, host.tid == self_host_});
    } else {
      *error = tids[i];
    }
  }
}

void VirtualMachine::Forget(int tid) {
  std::erase_if(spawned_, [tid](const Spawned& s) { return s.tid == tid; });
}

void VirtualMachine::KillSpawned() {
  for (const Spawned& s : spawned_) pvm_kill(s.tid);
  // Those on lost hosts are not waited for: the question would hang.
  const auto limit = std::chrono::steady_clock::now() + kEndLimit;
  for (const Spawned& s : spawned_) {
    while (s.local && pvm_pstat(s.tid) == PvmOk) {
      const auto now = std::chrono::steady_clock::now();
      if (now > limit) pvm_sendsig(s.tid, SIGKILL);
      if (now > limit + kEndLimit) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  spawned_.clear();
}

VirtualMachine::~VirtualMachine() {
  // pvm_exit waits for the last words of all tasks (pvm_catchout): for those of a lost machine it
  // would wait for minutes. Then PVM sees this process end instead.
  const bool waits =
      std::all_of(spawned_.begin(), spawned_.end(), [](const Spawned& s) { return s.local; });
  KillSpawned();
  if (waits) pvm_exit();
}

}  // namespace rayshade::parallel
