// Reports on the place where the parser stands, and whether the scene can still become a picture.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/lexer.h"

namespace rayshade {

class Reporter {
 public:
  Reporter(const Lexer* lexer, Diagnostics* diagnostics)
      : lexer_(lexer), diagnostics_(diagnostics), errors_before_(diagnostics->errors()) {}

  void Report(Severity severity, const std::string& text) {
    if (severity >= Severity::kError) in_doubt_ = true;
    diagnostics_->Report(severity, lexer_->place(), text);
  }
  void Warn(const std::string& text) { Report(Severity::kWarn, text); }
  void Error(const std::string& text) { Report(Severity::kError, text); }
  void Fatal(const std::string& text) { Report(Severity::kFatal, text); }
  // Not where something was said about this item already, and not about what follows such an item
  // directly: it would be about the same mistake.
  void Syntax(const std::string& text) {
    const bool follows = lexer_->tokens() == tokens_of_doubt_;
    if (!in_doubt_ && !follows) diagnostics_->ReportSyntax(lexer_->place(), text);
  }
  // With the token after the item read, where the item needed it to end.
  void EndItem() {
    if (in_doubt_) tokens_of_doubt_ = lexer_->tokens();
    in_doubt_ = false;
  }

  bool failed() const { return errors() > 0; }
  int errors() const { return diagnostics_->errors() - errors_before_; }
  Diagnostics* diagnostics() const { return diagnostics_; }

  // Where named objects are told of, with -v; null: nowhere. Not owned.
  std::FILE* log() const { return log_; }
  void set_log(std::FILE* log) { log_ = log; }

 private:
  const Lexer* lexer_;
  Diagnostics* diagnostics_;
  std::FILE* log_ = nullptr;
  int errors_before_;
  bool in_doubt_ = false;         // there was an error in this item
  uint64_t tokens_of_doubt_ = 0;  // read when such an item ended
};

}  // namespace rayshade
