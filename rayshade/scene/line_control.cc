// Lines that begin with #, as C preprocessors write them [rayshade4/1 s.2.3].
#include <charconv>

#include "rayshade/scene/lexer.h"

namespace rayshade {
namespace {

void SkipBlanks(std::string_view* text) {
  const size_t blanks = text->find_first_not_of(" \t");
  text->remove_prefix(blanks == std::string_view::npos ? text->size() : blanks);
}

}  // namespace

void ReadLineControl(std::string_view text, ScanState* state) {
  std::string_view rest = text;
  SkipBlanks(&rest);
  if (rest.starts_with("line")) {
    rest.remove_prefix(4);
    SkipBlanks(&rest);
  }
  // The number of the line that follows; the newline in between counts one.
  int number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error != std::errc() || number < 0) {
    state->diagnostics->Report(Severity::kFatal, state->place(),
                               "Unknown '#' control (" + std::string(text) + ").");
    return;
  }
  state->line = number - 1;

  // The name of the file; nothing written: as before.
  rest.remove_prefix(end - rest.data());
  SkipBlanks(&rest);
  if (!rest.starts_with('"')) return;
  rest.remove_prefix(1);
  const size_t quote = rest.find('"');
  if (quote == std::string_view::npos) return;
  state->file = quote == 0 ? "stdin" : std::string(rest.substr(0, quote));
}

}  // namespace rayshade
