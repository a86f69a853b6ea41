// From a scene file to a sink. Reads the whole language of Rayshade 4 [rayshade4/1].
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/scene_sink.h"

namespace rayshade {

// Reads options.input ("" : standard input), through cpp unless -u or where cpp could not matter;
// merges file and command line into Settings [rayshade4/1 s.6]. Goes on after errors to report more
// than one. Returns false where there were errors (all reported through diagnostics); the sink then
// has seen an incomplete scene and OnSettings was not called.
bool ParseScene(const Options& options, Diagnostics* diagnostics, SceneSink* sink);

// The same for a text in memory, without preprocessor; messages call it options.input, or stdin.
bool ParseText(std::string_view text, const Options& options, Diagnostics* diagnostics,
               SceneSink* sink);

}  // namespace rayshade
