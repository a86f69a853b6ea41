// Everything that the actions of the grammar work on. One for each file that is read.
#pragma once

#include "rayshade/scene/lights.h"
#include "rayshade/scene/objects.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/symbols.h"

namespace rayshade {

class ParserContext {
 public:
  ParserContext(const Options& options, ReadBytes read, std::string file, Diagnostics* diagnostics,
                SceneSink* sink);

  // Reads the whole input.
  void Read();
  // Then: hands on the settings of file and command line. False where there were errors.
  bool Complete();

  // For the grammar.
  void SyntaxError(const char* text) { reporter.Syntax(text); }
  int Recover(int token, bool in_body);
  TripleRef Keep(const Triple& triple) { return {triples_.Keep(triple)}; }
  NumberRef Keep(const NumberValue& value) { return {numbers_.Keep(value)}; }
  NumberRef KeepNumber(double number) { return Keep(NumberValue{number, nullptr}); }
  void EndItem() {
    triples_.Clear();
    numbers_.Clear();
    symbols.EndItem();
    reporter.EndItem();
  }
  void NameOutput(NameId file);
  void NameReport(NameId file);
  void SetReportFrequency(int lines);
  void SetQuiet();
  void SetVerbose();
  void Print(double number);
  std::shared_ptr<const ColorMap> ReadMap(NameId file);
  void BeginImage(NameId file);
  void SetComponent(ImageComponent component);

  Lexer lexer;
  Reporter reporter;
  GatedSink sink;
  Settings settings;
  Symbols symbols;
  Surfaces surfaces;
  DataFiles files;
  Objects objects;
  Lights lights;
  Air air;
  MappingSpec mapping;  // the last one read
  ImageSpec image;      // in the making

 private:
  ItemValues<Triple> triples_;
  ItemValues<NumberValue> numbers_;
  const Options& options_;
  bool output_named_ = false;
};

}  // namespace rayshade
