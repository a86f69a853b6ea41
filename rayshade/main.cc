// rayshade: options, then the scene, then its pictures. Everything else is elsewhere.
#include <exception>
#include <new>

#include "rayshade/common/diagnostics.h"
#include "rayshade/common/transform_chain.h"
#include "rayshade/render/render_picture.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/parse.h"
#include "rayshade/scene/scene_builder.h"

int main(int argc, char** argv) {
  using namespace rayshade;
  const Stopwatch stopwatch;
  const OptionsResult result = ParseOptions(argc, argv, {});
  if (!result.options) return result.status;
  Diagnostics diagnostics(result.options->program);
  diagnostics.set_quiet(result.options->quiet);
  try {
    SceneBuilder scene;
    if (!ParseScene(*result.options, &diagnostics, &scene)) return diagnostics.exit_status();
    return RenderPictures(*result.options, &scene, &diagnostics, stopwatch);
  } catch (const std::bad_alloc&) {
    diagnostics.Report(Severity::kError, {}, "Out of memory.");
  } catch (const DegenerateTransform& e) {
    diagnostics.Report(Severity::kFatal, {}, e.what());
  } catch (const std::exception& e) {
    diagnostics.Report(Severity::kError, {}, e.what());
  }
  return diagnostics.exit_status();
}
