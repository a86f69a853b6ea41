// Renders a scene given as text, sequentially and in parallel in one address space, for tests that
// compare the two.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parallel/message.h"
#include "parallel/object_spool.h"
#include "parallel/run_options.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/image/picture.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/scene_sink.h"

namespace rayshade::parallel {

// Parses text into a sink; the test fails where it has errors.
void ParseText(const std::string& text, SceneSink* sink);

struct TestPicture {
  Picture picture{0, 0};
  OpCounts counts;
  std::vector<Statistics> processes;  // of a parallel run
  uint64_t messages[kTags] = {};
  uint64_t bytes[kTags] = {};
};

TestPicture RenderSequentially(const std::string& text);
// seed: order of events. Throws what the run throws.
TestPicture RenderInParallel(const std::string& text, const RunOptions& options, uint64_t seed);

// The same for a command line: its first frame. Throws std::runtime_error where the scene has
// errors.
TestPicture RenderSequentially(const Options& options);
Settings ParseInto(const Options& options, ObjectSpool* spool);
// spool: parsed.
TestPicture RenderInParallel(ObjectSpool* spool, int frame, const RunOptions& options,
                             uint64_t seed);

// Same size and every colour and alpha equal to the bit.
bool Identical(const Picture& a, const Picture& b);

}  // namespace rayshade::parallel
