// What libpvm's codes mean; see pvm_call.h.
#include "parallel/pvm/pvm_call.h"

#include <pvm3.h>

namespace rayshade::parallel {

PvmError::PvmError(const std::string& attempt, int code)
    : std::runtime_error(attempt + ": " + PvmErrorText(code)), code_(code) {}

std::string PvmErrorText(int code) {
  switch (code) {
    case PvmBadParam:
      return "bad parameter";
    case PvmMismatch:
      return "counts do not match";
    case PvmOverflow:
      return "a value is too large";
    case PvmNoData:
      return "the message ends early";
    case PvmNoHost:
      return "no such host in the virtual machine";
    case PvmNoFile:
      return "no such file";
    case PvmDenied:
      return "permission denied";
    case PvmNoMem:
      return "no memory left";
    case PvmBadMsg:
      return "a message that cannot be decoded";
    case PvmSysErr:
      return "no answer from pvmd";
    case PvmNoBuf:
      return "no such buffer";
    case PvmNoTask:
      return "no such task";
    case PvmOutOfRes:
      return "out of resources";
    case PvmDupHost:
      return "the host is there already";
    case PvmCantStart:
      return "pvmd cannot be started";
    case PvmHostFail:
      return "the host has failed";
    case PvmDSysErr:
      return "pvmd met a system error";
    case PvmBadVersion:
      return "pvmds of different versions";
    default:
      return "PVM error " + std::to_string(code);
  }
}

int PvmCheck(int code, const std::string& attempt) {
  if (code < 0) throw PvmError(attempt, code);
  return code;
}

}  // namespace rayshade::parallel

// What libpvm forgets to free is not held against us where leaks are looked for (SAN=address).
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_suppressions() { return "leak:libpvm3\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
