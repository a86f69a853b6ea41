// Reading a scene; see parse.h.
#include "rayshade/scene/parse.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "rayshade/scene/input_text.h"
#include "rayshade/scene/parser_context.h"

namespace rayshade {

namespace {

// Where -v tells of the reading; opens the file of -V, which the report of the run goes on with.
class Log {
 public:
  ~Log() {
    if (stream_ && stream_ != stderr) std::fclose(stream_);
  }
  bool Open(const Options& options, Diagnostics* diagnostics) {
    const std::string& file = options.report_file;
    if (!options.verbose || (options.quiet && file.empty())) return true;
    stream_ = file.empty() ? stderr : std::fopen(file.c_str(), "w");
    if (stream_) return true;
    diagnostics->Report(Severity::kFatal, {}, "Cannot open stats file " + file + ".");
    return false;
  }
  std::FILE* stream() const { return stream_; }

 private:
  std::FILE* stream_ = nullptr;
};

}  // namespace

bool ParseScene(const Options& options, Diagnostics* diagnostics, SceneSink* sink) {
  Log log;
  InputText input;
  if (!log.Open(options, diagnostics)) return false;
  if (log.stream()) std::fprintf(log.stream(), "Reading input file...\n");
  if (!input.Open(options, diagnostics)) return false;
  ParserContext parser(
      options, [&input](char* buffer, size_t size) { return input.Read(buffer, size); },
      input.name(), diagnostics, sink);
  parser.reporter.set_log(log.stream());
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
