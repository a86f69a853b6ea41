// Calls of libpvm, checked: a failure is an exception that names the attempt, and libpvm itself
// says nothing (PvmAutoErr 0).
#pragma once

#include <stdexcept>
#include <string>

namespace rayshade::parallel {

class PvmError : public std::runtime_error {
 public:
  PvmError(const std::string& attempt, int code);
  int code() const { return code_; }

 private:
  int code_;
};

// A code of libpvm in words: "no such file".
std::string PvmErrorText(int code);

// The code, where it is not negative; else PvmError("attempt: reason").
int PvmCheck(int code, const std::string& attempt);

}  // namespace rayshade::parallel
