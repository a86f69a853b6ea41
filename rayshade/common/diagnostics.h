// What a run has to say about its input. Errors are defined by what happens to the picture
// [rayshade4/1 s.2.6]:
//   advise   a doubt; the picture is made; silent with -q
//   warn     something was left out or repaired; the picture is made
//   error    no picture is made, exit status 1; reading goes on, to report more than one
//   fatal    no picture is made, exit status 2
// Texts are written as "PROGRAM: KIND: FILE, line N: TEXT" on standard error, at once.
#pragma once

#include <cstdio>
#include <string>

namespace rayshade {

enum class Severity { kAdvise, kWarn, kError, kFatal };

// A place in the input; line 0: no place.
struct Place {
  std::string file;
  int line = 0;
};

class Diagnostics {
 public:
  // program: argv[0]; stream: not owned.
  explicit Diagnostics(std::string program, std::FILE* stream = stderr)
      : program_(std::move(program)), stream_(stream) {}

  void Report(Severity severity, const Place& place, const std::string& text);
  // "PROGRAM: Error: FILE: line N: TEXT", the form of syntax errors; severity error.
  void ReportSyntax(const Place& place, const std::string& text);

  void set_quiet(bool quiet) { quiet_ = quiet; }
  int errors() const { return errors_; }
  int warnings() const { return warnings_; }
  // 0 without errors, else that of the first one (1 error, 2 fatal): Rayshade stopped there.
  int exit_status() const { return exit_status_; }
  std::FILE* stream() const { return stream_; }  // for `print`, which no option silences

 private:
  std::string program_;
  std::FILE* stream_;
  bool quiet_ = false;
  int errors_ = 0;
  int warnings_ = 0;
  int exit_status_ = 0;
};

}  // namespace rayshade
