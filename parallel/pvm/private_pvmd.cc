// Starts and ends a pvmd; see private_pvmd.h.
#include "parallel/pvm/private_pvmd.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "parallel/pvm/guardian.h"

namespace rayshade::parallel {

namespace {

constexpr auto kStartLimit = std::chrono::seconds(10);

std::string Environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value && *value ? value : otherwise;
}

// Where libpvm looks for the address of its pvmd.
std::string AddressFile() {
  const std::string name = Environment("PVM_VMID", "");
  return Environment("PVM_TMP", "/tmp") + "/pvmd." + std::to_string(getuid()) +
         (name.empty() ? "" : "." + name);
}

bool Answers(const sockaddr* address, socklen_t size) {
  const int s = socket(address->sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (s < 0) return false;
  const bool answers = connect(s, address, size) == 0;
  close(s);
  return answers;
}

// An address as pvmd writes it: the path of a socket, or address and port in hexadecimal digits.
bool Answers(const std::string& address) {
  if (address.starts_with("/")) {
    sockaddr_un local{};
    local.sun_family = AF_UNIX;
    if (address.size() >= sizeof local.sun_path) return false;
    address.copy(local.sun_path, address.size());
    return Answers(reinterpret_cast<const sockaddr*>(&local), sizeof local);
  }
  unsigned host = 0, port = 0;
  if (std::sscanf(address.c_str(), "%x:%x", &host, &port) != 2) return false;
  sockaddr_in inet{};
  inet.sin_family = AF_INET;
  inet.sin_addr.s_addr = htonl(host);
  inet.sin_port = htons(static_cast<uint16_t>(port));
  return Answers(reinterpret_cast<const sockaddr*>(&inet), sizeof inet);
}

std::string FindPvmd() {
  const std::string root = Environment("PVM_ROOT", "/usr/lib/pvm3");
  std::vector<std::string> places = {root + "/lib/" + Environment("PVM_ARCH", "LINUX64") + "/pvmd3",
                                     root + "/lib/pvmd3", root + "/lib/pvmd"};
  std::istringstream path(Environment("PATH", "/usr/bin:/bin"));
  for (std::string folder; std::getline(path, folder, ':');) {
    places.push_back(folder + "/pvmd3");
    places.push_back(folder + "/pvmd");
  }
  for (const std::string& place : places)
    if (access(place.c_str(), X_OK) == 0) return place;
  throw std::runtime_error("PVM is not installed: there is no pvmd in " + root +
                           "/lib nor on the search path; try: apt-get install pvm");
}

std::string MakeFolder() {
  for (const std::string& parent :
       {Environment("PVM_TMP", ""), Environment("TMPDIR", ""), std::string("/tmp")}) {
    // pvmd's socket lies in it, and its name must be short.
    if (parent.empty() || parent.size() > 60) continue;
    std::string name = parent + "/prayshade.XXXXXX";
    if (mkdtemp(name.data())) return name;
  }
  throw std::runtime_error(std::string("no folder for pvmd can be made in /tmp: ") +
                           std::strerror(errno));
}

std::string LastLine(const std::string& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) last = line;
  return last;
}

}  // namespace

void PreparePvmEnvironment() {
  setenv("PVM_ROOT", "/usr/lib/pvm3", 0);
  if (geteuid() == 0) setenv("PVM_ALLOW_ROOT", "1", 0);
}

bool PvmdRuns() {
  // A task that a pvmd has started is told the address.
  const std::string told = Environment("PVMSOCK", "");
  if (!told.empty()) return Answers(told);
  std::ifstream in(AddressFile());
  std::string address;
  return in >> address && Answers(address);
}

PrivatePvmd::PrivatePvmd() {
  const std::string pvmd = FindPvmd();
  folder_ = MakeFolder();
  setenv("PVM_TMP", folder_.c_str(), 1);
  setenv("PVM_VMID", ("prayshade" + std::to_string(getpid())).c_str(), 0);
  unsetenv("PVMSOCK");
  try {
    StartGuardian(pvmd);
    AwaitPvmd();
  } catch (...) {
    End();
    throw;
  }
}

void PrivatePvmd::StartGuardian(const std::string& pvmd) {
  int life[2], status[2];
  if (pipe2(life, O_CLOEXEC) != 0 || pipe2(status, O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  guardian_ = fork();
  if (guardian_ < 0) throw std::runtime_error(std::string("fork: ") + std::strerror(errno));
  if (guardian_ == 0) {
    close(life[1]);
    close(status[0]);
    Guard(pvmd, folder_, life[0], status[1]);
  }
  close(life[0]);
  close(status[1]);
  life_ = life[1];
  status_ = status[0];
}

void PrivatePvmd::AwaitPvmd() {
  const auto limit = std::chrono::steady_clock::now() + kStartLimit;
  while (!PvmdRuns()) {
    pollfd ended{status_, POLLIN, 0};
    if (poll(&ended, 1, 2) != 0 || std::chrono::steady_clock::now() > limit) {
      std::string why = LastLine(folder_ + "/pvmd.out");
      if (why.empty()) why = LastLine(AddressFile().replace(folder_.size() + 1, 4, "pvml"));
      throw std::runtime_error("pvmd does not start" + (why.empty() ? "" : ": " + why));
    }
  }
}

void PrivatePvmd::End() {
  if (life_ >= 0) close(life_);
  if (status_ >= 0) close(status_);
  life_ = status_ = -1;
  if (guardian_ > 0)
    while (waitpid(guardian_, nullptr, 0) < 0 && errno == EINTR) {
    }
  guardian_ = -1;
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

}  // namespace rayshade::parallel
