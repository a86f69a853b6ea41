// Runs for tests; see parallel_run.h.
#include "tests/support/parallel_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "parallel/host_process.h"
#include "parallel/object_spool.h"
#include "parallel/sim/fault_plan.h"
#include "parallel/sim/simulator.h"
#include "parallel/trace_process.h"
#include "rayshade/common/diagnostics.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_sampling.h"
#include "rayshade/render/sequential_tracer.h"
#include "rayshade/scene/parse.h"
#include "rayshade/scene/scene_builder.h"

namespace rayshade::parallel {

void ParseText(const std::string& text, SceneSink* sink) {
  char name[] = "/tmp/parallel-test-XXXXXX";
  const int descriptor = mkstemp(name);
  ASSERT_GE(descriptor, 0);
  ASSERT_EQ(write(descriptor, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  close(descriptor);
  Options options;
  options.program = "test";
  options.input = name;
  options.raw_input = true;
  Diagnostics diagnostics("test");
  const bool parsed = ParseScene(options, &diagnostics, sink);
  unlink(name);
  ASSERT_TRUE(parsed) << text;
}

namespace {

TestPicture RenderFrame(SceneBuilder* builder, int frame) {
  const SceneBuilder::Built built = builder->Build(frame);
  const Camera camera(built.scene->settings(), frame);
  PixelSampling sampling(built.scene->settings(), camera, /*ahead=*/false);
  TestPicture result;
  while (!sampling.done()) {
    const std::vector<Sample> samples = sampling.Next(1024);
    RayBundle bundle;
    for (const Sample& s : samples) bundle.rays.push_back(camera.PrimaryRay(s));
    std::vector<RayResult> results(samples.size());
    TraceBundle(*built.scene, *built.objects, bundle, results, &result.counts);
    for (size_t i = 0; i < samples.size(); ++i) sampling.Put(samples[i], results[i]);
  }
  result.picture = sampling.picture();
  return result;
}

void ParseFile(const Options& options, SceneSink* sink) {
  Diagnostics diagnostics("test");
  diagnostics.set_quiet(true);
  if (!ParseScene(options, &diagnostics, sink)) throw std::runtime_error("errors in the scene");
}

}  // namespace

TestPicture RenderSequentially(const std::string& text) {
  SceneBuilder builder;
  ParseText(text, &builder);
  return RenderFrame(&builder, 0);
}

TestPicture RenderSequentially(const Options& options) {
  SceneBuilder builder;
  ParseFile(options, &builder);
  return RenderFrame(&builder, builder.settings().first_frame);
}

Settings ParseInto(const Options& options, ObjectSpool* spool) {
  ParseFile(options, spool);
  return spool->settings();
}

TestPicture RenderInParallel(const std::string& text, const RunOptions& options, uint64_t seed) {
  ObjectSpool spool;
  ParseText(text, &spool);
  return RenderInParallel(&spool, 0, options, seed);
}

TestPicture RenderInParallel(ObjectSpool* spool, int frame, const RunOptions& options,
                             uint64_t seed) {
  spool->Place(frame);
  HostProcess host(options, spool, frame);
  const Meter meter;
  std::vector<std::unique_ptr<TraceProcess>> trace;
  std::vector<Process*> processes{&host};
  for (int i = 0; i < options.processes; ++i) {
    trace.push_back(std::make_unique<TraceProcess>(&meter));
    processes.push_back(trace.back().get());
  }
  FaultTiming timing(PlanFaults(seed), processes.size());  // for its times
  Simulator simulator(processes, &timing);
  simulator.Run();
  if (host.phase() != HostProcess::Phase::kDone) throw std::runtime_error(host.failure());
  TestPicture result;
  result.picture = host.sampling().picture();
  result.processes = host.statistics();
  for (const Statistics& s : result.processes) result.counts += s.counts;
  for (int tag = 0; tag < kTags; ++tag) {
    result.messages[tag] = simulator.messages(static_cast<Tag>(tag));
    result.bytes[tag] = simulator.bytes(static_cast<Tag>(tag));
  }
  return result;
}

bool Identical(const Picture& a, const Picture& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const PixelValue &p = a.at(x, y), &q = b.at(x, y);
      if (std::memcmp(&p.color, &q.color, sizeof p.color) != 0 || p.alpha != q.alpha) return false;
    }
  }
  return true;
}

}  // namespace rayshade::parallel
