// `make accuracy`: error against time of every choice that trades one for the other (doc/charts,
// doc/performance.md).
//
//   accuracy DATA [CHART]...   writes DATA/CHART.csv for antialiasing-balls, antialiasing-room,
//   antialiasing-first, area,
//                              extended, light-cutoff, depth-balls and depth-mirrors, or for those
//                              named
//
// Error is taken against a converged picture of 1,024 jittered samples in each pixel; time is
// processor time of tracing, in yardsticks of one plain sample per pixel of the same scene that are
// rendered before and after each run.
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "rayshade/scene/quality.h"
#include "tests/bench/measured_scene.h"

namespace rayshade::bench {
namespace {

constexpr int kRuns = 3, kPixels = 96;

std::string Text(const char* format, double a, double b = 0) {
  char text[60];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

// n x n samples in every pixel.
Way Fixed(int n, bool jitter, SamplePattern pattern) {
  return [=](Settings* s) {
    s->samples = n;
    s->jitter = jitter;
    s->pattern = pattern;
    s->every_pixel_full = true;
  };
}

Way Adaptive(int n, double contrast, SamplePattern pattern) {
  return [=](Settings* s) {
    s->samples = n;
    s->jitter = true;
    s->pattern = pattern;
    s->contrast = {contrast, contrast, contrast};
  };
}

Way WithCells(Way way, int area_cells) {
  return [=](Settings* s) {
    way(s);
    s->area_cells = area_cells;
  };
}

class Chart {
 public:
  Chart(const std::string& data, const std::string& name) : file_(data + "/" + name + ".csv") {
    std::fprintf(stderr, "%s\n", name.c_str());
  }
  ~Chart() {
    MarkFront(&points_);
    WriteCsv(file_, points_);
  }
  Chart(const Chart&) = delete;
  Chart& operator=(const Chart&) = delete;

  void Add(MeasuredScene* scene, const std::string& curve, const std::string& parameter,
           const Way& way) {
    points_.push_back(scene->Measure(curve, parameter, way, kRuns));
  }
  void AddQualities(MeasuredScene* scene) {
    for (const char* name : {"draft", "rayshade", "fine", "reference"}) {
      Add(scene, "--quality", name, [name](Settings* s) {
        // What the file leaves to the defaults: the scenes of this project ask for one plain
        // sample.
        const Settings defaults;
        s->samples = defaults.samples;
        s->jitter = defaults.jitter;
        s->contrast = defaults.contrast;
        ApplyQuality(*QualityNamed(name), s);
      });
    }
  }

 private:
  std::string file_;
  std::vector<Point> points_;
};

void Antialiasing(Chart* chart, MeasuredScene* scene) {
  scene->Converge(8, 16, [](Settings*) {});
  const auto kRayshade = SamplePattern::kRayshade, kLow = SamplePattern::kLowDiscrepancy;
  for (const int n : {1, 2, 3, 4, 6, 8}) {
    const std::string parameter = Text("%g x %g", n, n);
    chart->Add(scene, "regular n x n", parameter, Fixed(n, false, kRayshade));
    chart->Add(scene, "jittered n x n (stratified)", parameter, Fixed(n, true, kRayshade));
    chart->Add(scene, "low-discrepancy n x n", parameter, Fixed(n, true, kLow));
  }
  for (const double contrast : {.4, .2, .1, .05, .025, .0125}) {
    const std::string parameter = Text("T %g", contrast);
    chart->Add(scene, "contrast rule on jittered 3 x 3", parameter,
               Adaptive(3, contrast, kRayshade));
    chart->Add(scene, "contrast rule on low-disc. 2 x 2", parameter, Adaptive(2, contrast, kLow));
    chart->Add(scene, "contrast rule on low-disc. 4 x 4", parameter, Adaptive(4, contrast, kLow));
    chart->Add(scene, "contrast rule on low-disc. 8 x 8", parameter, Adaptive(8, contrast, kLow));
  }
  chart->AddQualities(scene);
}

const char kSoftShadows[] = "tests/bench/soft_shadows.ray";

void Area(Chart* chart) {
  const auto kRayshade = SamplePattern::kRayshade, kLow = SamplePattern::kLowDiscrepancy;
  MeasuredScene reference(kSoftShadows, kPixels, kPixels, "-DCELLS=4");
  reference.Converge(8, 16, [](Settings*) {});
  for (const int cells : {1, 2, 4, 8}) {
    MeasuredScene scene(kSoftShadows, kPixels, kPixels, "-DCELLS=" + std::to_string(cells));
    scene.ConvergeAs(reference);
    const std::string parameter = Text("%g x %g", cells, cells);
    chart->Add(&scene, "all cells; 1 sample", parameter, Fixed(1, true, kRayshade));
    chart->Add(&scene, "all cells; jittered 4 x 4", parameter, Fixed(4, true, kRayshade));
    chart->Add(&scene, "all cells; contrast .05 on jittered 4 x 4", parameter,
               Adaptive(4, .05, kRayshade));
  }
  MeasuredScene scene(kSoftShadows, kPixels, kPixels, "-DCELLS=8");
  scene.ConvergeAs(reference);
  for (const int cells : {1, 2, 4, 8, 16}) {
    const std::string parameter = Text("%g of 64", cells);
    chart->Add(&scene, "some cells; jittered 4 x 4", parameter,
               WithCells(Fixed(4, true, kRayshade), cells));
    chart->Add(&scene, "some cells; low-disc. 4 x 4", parameter,
               WithCells(Fixed(4, true, kLow), cells));
    chart->Add(&scene, "some cells; contrast .05 on low-disc. 4 x 4", parameter,
               WithCells(Adaptive(4, .05, kLow), cells));
    chart->Add(&scene, "some cells; contrast .05 on low-disc. 8 x 8", parameter,
               WithCells(Adaptive(8, .05, kLow), cells));
  }
  chart->AddQualities(&scene);
}

void Extended(Chart* chart) {
  const auto kRayshade = SamplePattern::kRayshade, kLow = SamplePattern::kLowDiscrepancy;
  MeasuredScene scene(kSoftShadows, kPixels, kPixels);
  // From 6 x 6 on, the original's numbers of samples run from 1: one of them lies outside of the
  // light.
  scene.Converge(4, 64, [](Settings*) {});
  for (const int n : {1, 2, 3, 4, 6, 8}) {
    const std::string parameter = Text("%g x %g", n, n);
    chart->Add(&scene, "jittered n x n", parameter, Fixed(n, true, kRayshade));
    chart->Add(&scene, "low-discrepancy n x n", parameter, Fixed(n, true, kLow));
  }
  for (const double contrast : {.4, .2, .1, .05, .025, .0125}) {
    const std::string parameter = Text("T %g", contrast);
    chart->Add(&scene, "contrast rule on jittered 4 x 4", parameter,
               Adaptive(4, contrast, kRayshade));
    chart->Add(&scene, "contrast rule on low-disc. 4 x 4", parameter, Adaptive(4, contrast, kLow));
    chart->Add(&scene, "contrast rule on low-disc. 8 x 8", parameter, Adaptive(8, contrast, kLow));
  }
  chart->AddQualities(&scene);
}

// Sampling of 16 per pixel stays the same; lights that could add less than a limit arrive untested.
void LightCutoff(Chart* chart) {
  MeasuredScene scene("scenes/room30.ray", kPixels, kPixels);
  scene.Converge(8, 16, [](Settings*) {});
  const Way sampling = Fixed(4, true, SamplePattern::kLowDiscrepancy);
  for (const double limit : {0., 1. / 1024, 1. / 512, 1. / 256, 1. / 128, 1. / 64, 1. / 32}) {
    const std::string parameter = limit > 0 ? Text("1/%g", 1 / limit) : "none";
    chart->Add(&scene, "shadow cutoff", parameter, [&](Settings* s) {
      sampling(s);
      s->light_cutoff = limit;
    });
  }
}

void Depth(Chart* chart, MeasuredScene* scene) {
  const auto endless = [](Settings* s) {
    s->max_depth = 16;
    s->cutoff = {1e-4, 1e-4, 1e-4};
  };
  scene->Converge(8, 16, endless);
  const Way sampling = Fixed(8, true, SamplePattern::kLowDiscrepancy);
  for (const int depth : {0, 1, 2, 3, 4, 5, 8, 12}) {
    chart->Add(scene, "depth limit at cutoff .0001", Text("%g", depth), [&](Settings* s) {
      endless(s);
      sampling(s);
      s->max_depth = depth;
    });
  }
  for (const double cutoff : {.5, .2, .1, .05, .02, .01, .005, .002}) {
    chart->Add(scene, "cutoff at depth 16", Text("%g", cutoff), [&](Settings* s) {
      endless(s);
      sampling(s);
      s->cutoff = {cutoff, cutoff, cutoff};
    });
  }
  for (const double cutoff : {.1, .05, .02, .002}) {
    chart->Add(scene, "cutoff at depth 5", Text("%g", cutoff), [&](Settings* s) {
      sampling(s);
      s->max_depth = 5;
      s->cutoff = {cutoff, cutoff, cutoff};
    });
  }
}

}  // namespace

int Main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: accuracy DATA [CHART]...\n");
    return 2;
  }
  const std::string data = argv[1];
  const auto wanted = [&](const char* name) {
    for (int i = 2; i < argc; ++i) {
      if (std::strcmp(argv[i], name) == 0) return true;
    }
    return argc == 2;
  };
  struct Scene {
    const char *name, *file;
  };
  for (const Scene& s : {Scene{"antialiasing-balls", "scenes/balls5.ray"},
                         Scene{"antialiasing-room", "scenes/room8.ray"},
                         Scene{"antialiasing-first", "scenes/first.ray"}}) {
    if (!wanted(s.name)) continue;
    Chart chart(data, s.name);
    MeasuredScene scene(s.file, kPixels, kPixels);
    Antialiasing(&chart, &scene);
  }
  for (const Scene& s : {Scene{"depth-balls", "scenes/balls5.ray"},
                         Scene{"depth-mirrors", "tests/bench/mirrors.ray"}}) {
    if (!wanted(s.name)) continue;
    Chart chart(data, s.name);
    MeasuredScene scene(s.file, kPixels, kPixels);
    Depth(&chart, &scene);
  }
  if (wanted("area")) {
    Chart chart(data, "area");
    Area(&chart);
  }
  if (wanted("extended")) {
    Chart chart(data, "extended");
    Extended(&chart);
  }
  if (wanted("light-cutoff")) {
    Chart chart(data, "light-cutoff");
    LightCutoff(&chart);
  }
  return 0;
}

}  // namespace rayshade::bench

int main(int argc, char** argv) { return rayshade::bench::Main(argc, argv); }
