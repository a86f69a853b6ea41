// Reports on the place where the parser stands, and whether the scene can still become a picture.
#pragma once

#include <string>

#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/lexer.h"

namespace rayshade {

class Reporter {
 public:
  Reporter(const Lexer* lexer, Diagnostics* diagnostics)
      : lexer_(lexer), diagnostics_(diagnostics), errors_before_(diagnostics->errors()) {}

  void Report(Severity severity, const std::string& text) {
    last_ = lexer_->place();
    diagnostics_->Report(severity, last_, text);
  }
  void Warn(const std::string& text) { Report(Severity::kWarn, text); }
  void Error(const std::string& text) { Report(Severity::kError, text); }
  void Fatal(const std::string& text) { Report(Severity::kFatal, text); }
  // Not where something was said about this line already: it would be about the same mistake.
  void Syntax(const std::string& text) {
    const Place here = lexer_->place();
    if (here.line != last_.line || here.file != last_.file) diagnostics_->ReportSyntax(here, text);
  }

  bool failed() const { return errors() > 0; }
  int errors() const { return diagnostics_->errors() - errors_before_; }
  Diagnostics* diagnostics() const { return diagnostics_; }

 private:
  const Lexer* lexer_;
  Diagnostics* diagnostics_;
  int errors_before_;
  Place last_;  // of the last report that was no syntax error
};

}  // namespace rayshade
