// The parser's run, and the actions that are too small for a class of their own; see
// parser_context.h.
#include "rayshade/scene/parser_context.h"

#include <algorithm>
#include <new>
#include <string>

#include "rayshade/scene/grammar.h"
#include "rayshade/scene/merge_settings.h"

namespace rayshade {
namespace {

constexpr int kMostErrors = 100;  // reading stops there

}  // namespace

ParserContext::ParserContext(const Options& options, ReadBytes read, std::string file,
                             Diagnostics* diagnostics, SceneSink* out)
    : lexer(std::move(read), std::move(file), diagnostics),
      reporter(&lexer, diagnostics),
      sink(out, &reporter),
      settings(SettingsBeforeFile(options)),
      symbols(&lexer, &reporter),
      surfaces(&lexer, &sink, &reporter),
      files(options.input),
      objects(&lexer, &sink, &reporter, &surfaces, &files, options.flip_normals),
      lights(&sink, &reporter),
      air(&sink, &reporter),
      options_(options),
      output_named_(options.output.has_value()) {}

void ParserContext::Read() {
  try {
    rayshade_parse(this);
  } catch (const std::bad_alloc&) {
    reporter.Fatal("Out of memory.");
  }
}

bool ParserContext::Complete() {
  if (!reporter.failed() && !objects.anything_placed()) {
    reporter.diagnostics()->Report(Severity::kFatal, {}, "Nothing to be rendered.");
  }
  sink.OnSettings(SettingsAfterFile(settings, options_));  // not after errors
  return !reporter.failed();
}

int ParserContext::Recover(int token, bool in_body) {
  objects.Abandon();
  EndItem();
  if (reporter.errors() < kMostErrors) return lexer.SkipToItem(token, in_body);
  reporter.Error("Too many errors; the rest is not read.");
  return 0;
}

void ParserContext::NameOutput(NameId file) {
  if (output_named_) {
    return reporter.Warn("Ignoring output file name \"" + lexer.text(file) + "\".");
  }
  output_named_ = true;
  settings.output = lexer.text(file);
}

void ParserContext::NameReport(NameId file) {
  if (settings.report_file.empty()) settings.report_file = lexer.text(file);
}

void ParserContext::SetReportFrequency(int lines) {
  if (lines < 1) reporter.Warn("Invalid report frequency; every line is reported.");
  settings.report_frequency = std::max(lines, 1);
}

void ParserContext::SetQuiet() {
  settings.quiet = true;
  reporter.diagnostics()->set_quiet(true);
}

void ParserContext::SetVerbose() {
  settings.verbose = true;
  if (!reporter.log() && !settings.quiet) reporter.set_log(stderr);
}

void ParserContext::Print(double number) {
  std::fprintf(reporter.diagnostics()->stream(), "%f\n", number);
}

std::shared_ptr<const ColorMap> ParserContext::ReadMap(NameId file) {
  try {
    return files.ReadColorMap(lexer.text(file));
  } catch (const DataFileError& error) {
    reporter.Report(error.severity, error.what());
    return nullptr;
  }
}

void ParserContext::BeginImage(NameId file) {
  image = {};
  try {
    image.image = files.ReadImage(lexer.text(file));
  } catch (const DataFileError& error) {
    reporter.Report(error.severity, error.what());
  }
}

void ParserContext::SetComponent(ImageComponent component) {
  image.component = component;
  const bool color = component == ImageComponent::kAmbient ||
                     component == ImageComponent::kDiffuse || component == ImageComponent::kBody ||
                     component == ImageComponent::kSpecular;
  if (image.image && image.image->channels != 1 && !color) {
    reporter.Fatal("Image component needs an image of one channel, " + image.image->file + " has " +
                   std::to_string(image.image->channels) + ".");
  }
}

}  // namespace rayshade
