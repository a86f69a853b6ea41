// See measured_scene.h.
#include "tests/bench/measured_scene.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_sampling.h"
#include "rayshade/render/sequential_tracer.h"
#include "rayshade/scene/parse.h"

namespace rayshade::bench {
namespace {

constexpr size_t kBundle = 1024;
constexpr double kEnoughSeconds = 1;  // of measuring one point
constexpr double kAlike = .1;         // of two times or two errors

// Processor time: others on the machine do not count.
double CpuSeconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

Color Clamped(const Color& c) {
  const auto clamp = [](double x) { return std::clamp(x, 0., 1.); };
  return {clamp(c.r), clamp(c.g), clamp(c.b)};
}

void OnePlainSample(Settings* s) {
  s->samples = 1;
  s->jitter = false;
  s->pattern = SamplePattern::kRayshade;
  s->area_cells = 1;
}

}  // namespace

struct MeasuredScene::Rendered {
  std::vector<Color> pixels;
  double seconds = 0;
  OpCounts counts;
};

MeasuredScene::MeasuredScene(const std::string& file, int width, int height,
                             const std::string& defines) {
  Options options;
  options.program = "accuracy";
  options.input = file;
  options.resolution = {width, height};
  if (!defines.empty()) options.preprocessor_arguments = {defines};
  Diagnostics diagnostics(options.program);
  diagnostics.set_quiet(true);
  if (!ParseScene(options, &diagnostics, &builder_)) {
    std::fprintf(stderr, "accuracy: %s has errors\n", file.c_str());
    std::exit(1);
  }
  built_ = builder_.Build(0);
  settings_ = builder_.settings();
}

MeasuredScene::~MeasuredScene() = default;

MeasuredScene::Rendered MeasuredScene::Render(const Way& way) {
  Settings& settings = built_.scene->spec.settings;
  settings = settings_;
  way(&settings);
  const Camera camera(settings, 0);
  PixelSampling sampling(settings, camera, /*ahead=*/false);
  SequentialTracer tracer(built_.scene.get(), built_.objects.get());
  Rendered rendered;
  RayBundle bundle;
  std::vector<RayResult> results;
  const double begin = CpuSeconds();
  while (!sampling.done()) {
    const std::vector<Sample> samples = sampling.Next(kBundle);
    bundle.clear();
    for (const Sample& sample : samples) bundle.rays.push_back(camera.PrimaryRay(sample));
    results.assign(samples.size(), {});
    tracer.Trace(bundle, results, &rendered.counts);
    for (size_t i = 0; i < samples.size(); ++i) sampling.Put(samples[i], results[i]);
  }
  rendered.seconds = CpuSeconds() - begin;
  const Picture& picture = sampling.picture();
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) rendered.pixels.push_back(picture.at(x, y).color);
  }
  return rendered;
}

void MeasuredScene::Converge(int n, int seeds, const Way& base) {
  reference_.assign(size_t(settings_.width) * settings_.height, {});
  for (int seed = 1; seed <= seeds; ++seed) {
    const Rendered rendered = Render([&](Settings* s) {
      base(s);
      s->samples = n;
      s->jitter = true;
      s->every_pixel_full = true;
      s->seed = 1000 + seed;
    });
    for (size_t i = 0; i < reference_.size(); ++i) reference_[i] += rendered.pixels[i];
  }
  for (Color& pixel : reference_) pixel = Clamped(1. / seeds * pixel);
}

void MeasuredScene::Compare(const Rendered& rendered, Point* point) const {
  double squares = 0;
  size_t off = 0;
  for (size_t i = 0; i < reference_.size(); ++i) {
    const Color pixel = Clamped(rendered.pixels[i]);
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
      const double difference = pixel[c] - reference_[i][c];
      squares += difference * difference;
      worst = std::max(worst, std::fabs(difference));
    }
    off += worst > 2. / 255;
  }
  const double pixels = double(reference_.size());
  point->error = 255 * std::sqrt(squares / (3 * pixels));
  point->share_off = 100 * double(off) / pixels;
}

Point MeasuredScene::Measure(const std::string& curve, const std::string& parameter, const Way& way,
                             int runs) {
  std::vector<double> ratios;
  Rendered rendered;
  const double begin = CpuSeconds();
  for (int run = 0; run < runs && CpuSeconds() - begin < kEnoughSeconds; ++run) {
    const double before = Render(OnePlainSample).seconds;
    rendered = Render(way);
    const double after = Render(OnePlainSample).seconds;
    ratios.push_back(rendered.seconds / (.5 * (before + after)));
  }
  std::sort(ratios.begin(), ratios.end());
  Point point;
  point.curve = curve;
  point.parameter = parameter;
  point.time_ratio = ratios[ratios.size() / 2];
  const double pixels = double(reference_.size());
  point.samples = double(rendered.counts.primary_rays) / pixels;
  point.shadow_rays = double(rendered.counts.shadow_rays) / pixels;
  point.secondary_rays =
      double(rendered.counts.reflected_rays + rendered.counts.refracted_rays) / pixels;
  Compare(rendered, &point);
  std::fprintf(stderr, "  %-34s %-10s %8.2f x  error %6.3f  off %6.2f%%\n", curve.c_str(),
               parameter.c_str(), point.time_ratio, point.error, point.share_off);
  return point;
}

void MarkFront(std::vector<Point>* points) {
  std::vector<Point*> by_time;
  for (Point& p : *points) {
    if (p.curve != "--quality") by_time.push_back(&p);
  }
  std::sort(by_time.begin(), by_time.end(),
            [](const Point* a, const Point* b) { return a->time_ratio < b->time_ratio; });
  Point* last = nullptr;
  for (Point* p : by_time) {
    if (last != nullptr && p->error > (1 - kAlike) * last->error) continue;
    if (last != nullptr && p->time_ratio < (1 + kAlike) * last->time_ratio) last->front = false;
    p->front = true;
    last = p;
  }
}

void WriteCsv(const std::string& file, const std::vector<Point>& points) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (out == nullptr) {
    std::fprintf(stderr, "accuracy: cannot write %s\n", file.c_str());
    std::exit(1);
  }
  std::fprintf(out,
               "curve,parameter,time,error_rms_255,off_percent,samples_per_pixel,"
               "shadow_rays_per_pixel,secondary_rays_per_pixel,front\n");
  for (const Point& p : points) {
    std::fprintf(out, "%s,%s,%.3f,%.4f,%.3f,%.3f,%.3f,%.3f,%d\n", p.curve.c_str(),
                 p.parameter.c_str(), p.time_ratio, p.error, p.share_off, p.samples, p.shadow_rays,
                 p.secondary_rays, p.front);
  }
  std::fclose(out);
}

}  // namespace rayshade::bench
