// prayshade-trace: one trace process; prayshade starts it.
#include <pvm3.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <memory>

#include "parallel/pvm/trace_session.h"
#include "parallel/trace_process.h"

namespace rayshade::parallel {
namespace {

int TraceMain() {
  pvm_setopt(PvmAutoErr, 0);
  // Started by hand there is no virtual machine to look for.
  const int host = std::getenv("PVMSOCK") ? pvm_parent() : PvmNoParent;
  if (host < 0) {
    std::fprintf(stderr, "prayshade-trace is started by prayshade, not by hand\n");
    return 2;
  }
  int status = 1;
  try {
    TraceSession session(host,
                         [](const Meter* meter) { return std::make_unique<TraceProcess>(meter); });
    status = session.Run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "prayshade-trace: %s\n", e.what());
  }
  pvm_exit();
  return status;
}

}  // namespace
}  // namespace rayshade::parallel

int main() { return rayshade::parallel::TraceMain(); }
