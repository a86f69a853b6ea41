// Reading a scene; see parse.h.
#include "rayshade/scene/parse.h"

#include <algorithm>
#include <cstring>

#include "rayshade/scene/input_text.h"
#include "rayshade/scene/parser_context.h"

namespace rayshade {

bool ParseScene(const Options& options, Diagnostics* diagnostics, SceneSink* sink) {
  InputText input;
  if (!input.Open(options, diagnostics)) return false;
  ParserContext parser(
      options, [&input](char* buffer, size_t size) { return input.Read(buffer, size); },
      input.name(), diagnostics, sink);
  parser.Read();
  input.Finish();
  return parser.Complete();
}

bool ParseText(std::string_view text, const Options& options, Diagnostics* diagnostics,
               SceneSink* sink) {
  const auto read = [&text](char* buffer, size_t size) {
    const size_t count = std::min(size, text.size());
    std::memcpy(buffer, text.data(), count);
    text.remove_prefix(count);
    return count;
  };
  ParserContext parser(options, read, options.input.empty() ? "stdin" : options.input, diagnostics,
                       sink);
  parser.Read();
  return parser.Complete();
}

}  // namespace rayshade
