// The guardian; see guardian.h. It is the reaper of every orphan below it (PR_SET_CHILD_SUBREAPER),
// so that tasks whose pvmd is gone are its children and can be found.
#include "parallel/pvm/guardian.h"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/select.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace rayshade::parallel {

namespace {

// Between asking to end and killing. A pvmd can hang in its own signal handlers (a SIGTERM within
// its SIGPIPE's); what it would clean up lies in the folder, which goes as a whole.
constexpr int kPatienceMs = 500;

void SetSignals(void (*action)(int)) {
  for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT}) signal(s, action);
}

void RedirectTo(const std::string& file) {
  const int null = open("/dev/null", O_RDONLY);
  const int out = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (null >= 0) dup2(null, STDIN_FILENO);
  if (out >= 0) {
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
  }
}

// PVM waits by select, which knows 1024 descriptors; and pvmd closes all that there could be before
// it starts a task.
void LimitFiles() {
  rlimit limit;
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur <= FD_SETSIZE) return;
  limit.rlim_cur = FD_SETSIZE;
  setrlimit(RLIMIT_NOFILE, &limit);
}

pid_t StartPvmd(const std::string& pvmd) {
  const pid_t child = fork();
  if (child != 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  SetSignals(SIG_DFL);
  LimitFiles();
  execl(pvmd.c_str(), pvmd.c_str(), "-n127.0.0.1", static_cast<char*>(nullptr));
  std::perror(pvmd.c_str());
  _exit(127);
}

// The parent of a process; 0 where there is none of that number.
pid_t ParentOf(pid_t process) {
  char name[64];
  std::snprintf(name, sizeof name, "/proc/%d/stat", process);
  std::FILE* in = std::fopen(name, "r");
  if (!in) return 0;
  int parent = 0;
  // The name of the program, in parentheses, is at most 15 bytes, and no ')' of ours is among them.
  if (std::fscanf(in, "%*d (%*[^)]) %*c %d", &parent) != 1) parent = 0;
  std::fclose(in);
  return parent;
}

std::vector<pid_t> Children() {
  std::vector<pid_t> children;
  DIR* all = opendir("/proc");
  if (!all) return children;
  while (const dirent* entry = readdir(all)) {
    const pid_t process = std::atoi(entry->d_name);
    if (process > 0 && ParentOf(process) == getpid()) children.push_back(process);
  }
  closedir(all);
  return children;
}

// Waits until no child is left, at most so long.
bool AllGoneWithin(int milliseconds) {
  for (int waited = 0;; ++waited) {
    pid_t ended;
    do {
      ended = waitpid(-1, nullptr, WNOHANG);
    } while (ended > 0);
    if (ended < 0) return true;
    if (waited >= milliseconds) return false;
    poll(nullptr, 0, 1);
  }
}

void EndAll(pid_t pvmd) {
  if (pvmd > 0) kill(pvmd, SIGTERM);
  for (int attempt = 0; !AllGoneWithin(kPatienceMs) && attempt < 8; ++attempt)
    for (const pid_t child : Children()) kill(child, SIGKILL);
}

}  // namespace

void Guard(const std::string& pvmd, const std::string& folder, int life, int status) {
  // A process group of its own: what the terminal sends to the run's does not reach it.
  setsid();
  SetSignals(SIG_IGN);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_NAME, "prayshade-guard");
  RedirectTo(folder + "/pvmd.out");

  pid_t child = StartPvmd(pvmd);
  for (bool open = true; open;) {
    pollfd other{life, POLLIN, 0};
    open = poll(&other, 1, 20) <= 0;
    const pid_t ended = waitpid(-1, nullptr, WNOHANG);
    if (ended > 0 && ended == child) {
      child = -1;
      close(status);
    }
  }
  EndAll(child);
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  _exit(0);
}

}  // namespace rayshade::parallel
