// From characters to tokens [rayshade4/1 s.1, 2.3, 2.4]. Reads in large pieces and keeps none of
// them: memory does not grow with the length of the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/keywords.h"
#include "rayshade/scene/names.h"
#include "rayshade/scene/parser_value.h"

namespace rayshade {

// Fills the buffer with the next bytes of the input; 0: there are no more.
using ReadBytes = std::function<size_t(char* buffer, size_t size)>;

// What the scanner's rules work on.
struct ScanState {
  ReadBytes read;
  Diagnostics* diagnostics = nullptr;
  NameTable names;  // the keywords come first
  std::vector<Keyword> keywords;
  std::string file;     // as messages name it
  int line = 1;         // of the last token
  int parentheses = 0;  // open ones: signs are operators inside

  Place place() const { return {file, line}; }
};

class Lexer {
 public:
  // file: what messages call the input, until a # line says otherwise.
  Lexer(ReadBytes read, std::string file, Diagnostics* diagnostics);
  ~Lexer();
  Lexer(const Lexer&) = delete;
  Lexer& operator=(const Lexer&) = delete;

  // The next token of the grammar; 0 at the end of the input.
  int Next(ParserValue* value);
  // Reads on from `token` until one with which an item may begin (in a body: an aggregate's item,
  // or `end`), or the end; returns that one. Open parentheses are forgotten.
  int SkipToItem(int token, bool in_body);

  const std::string& text(NameId name) const { return state_.names.text(name); }
  NameTable* names() { return &state_.names; }
  Place place() const { return state_.place(); }
  uint64_t tokens() const { return tokens_; }  // read so far

 private:
  ScanState state_;
  std::vector<WordRole> roles_;  // by token
  uint64_t tokens_ = 0;
  void* scanner_;  // flex's own
};

// A line that begins with #: where the text comes from. text: without the #. Anything else is a
// fatal error.
void ReadLineControl(std::string_view text, ScanState* state);

}  // namespace rayshade
