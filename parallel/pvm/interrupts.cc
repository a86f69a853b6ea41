// See interrupts.h.
#include "parallel/pvm/interrupts.h"

#include <signal.h>

#include <initializer_list>

namespace rayshade::parallel {

namespace {

volatile sig_atomic_t came = 0;

void Remember(int signal) { came = signal; }

void Set(void (*handler)(int), int flags) {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler == SIG_IGN) continue;
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace

Interrupts::Interrupts() {
  Set(Remember, static_cast<int>(SA_RESETHAND));
  signal(SIGPIPE, SIG_IGN);
}
Interrupts::~Interrupts() { Set(SIG_DFL, 0); }

int Interrupts::Came() { return came; }

}  // namespace rayshade::parallel
