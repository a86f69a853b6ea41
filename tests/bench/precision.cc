// Single against double precision, for boxes, hits and shading (`make accuracy`): each choice in
// the tracer of ball_tracer.h.
//
//   precision DATA   renders scenes/balls5.ray (spheres, view and light; 66,430 spheres) and writes
//   DATA/precision.csv
//
// What it leaves out: kernels that test 8 objects with one instruction would have twice the lanes
// in single precision; one ray against one object cannot show that.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/bench/ball_tracer.h"

namespace rayshade::bench {
namespace {

std::vector<Ball> ReadBalls(const char* file) {
  std::vector<Ball> balls;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("sphere ")) continue;
    Ball ball;
    ball.mirror = !line.starts_with("sphere dull ");
    std::istringstream numbers(line.substr(ball.mirror ? 7 : 12));
    numbers >> ball.radius >> ball.center.x >> ball.center.y >> ball.center.z;
    balls.push_back(ball);
  }
  return balls;
}

double CpuSeconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// Root mean square (1/255) and percent of pixels with a channel off by more than `limit`; colours
// clamped.
struct Difference {
  double error = 0, off = 0;
};
Difference Compare(const std::vector<Vec<double>>& a, const std::vector<Vec<double>>& b,
                   double limit) {
  const auto apart = [](double p, double q) {
    return std::fabs(std::clamp(p, 0., 1.) - std::clamp(q, 0., 1.));
  };
  Difference d;
  for (size_t i = 0; i < a.size(); ++i) {
    const double x = apart(a[i].x, b[i].x), y = apart(a[i].y, b[i].y), z = apart(a[i].z, b[i].z);
    d.error += x * x + y * y + z * z;
    d.off += std::max({x, y, z}) > limit;
  }
  d.error = 255 * std::sqrt(d.error / (3 * double(a.size())));
  d.off *= 100 / double(a.size());
  return d;
}

class Precision {
 public:
  Precision(std::vector<Ball> balls, std::FILE* out)
      : balls_(std::move(balls)), exact_(balls_), out_(out) {
    converged_.resize(kPixels * kPixels);
    for (uint64_t seed = 1000; seed < 1016; ++seed) {
      const auto picture = exact_.Render(8, seed);
      for (size_t i = 0; i < picture.size(); ++i) {
        converged_[i] = converged_[i] + 1. / 16 * picture[i];
      }
    }
    std::fprintf(out_,
                 "curve,parameter,time,error_rms_255,off_percent,"
                 "difference_from_double_rms_255,pixels_that_differ_percent,front\n");
  }

  template <class B, class H, class S>
  void Measure(const char* name) const {
    const Tracer<B, H, S> tracer(balls_);
    for (const int n : {1, 2, 4, 8}) {
      std::vector<double> ratios;
      std::vector<Vec<double>> picture;
      for (int run = 0; run < 5; ++run) {
        const double begin = CpuSeconds();
        exact_.Render(1, 1);
        const double yardstick = CpuSeconds() - begin;
        picture = tracer.Render(n, 1);
        ratios.push_back((CpuSeconds() - begin - yardstick) / yardstick);
      }
      std::sort(ratios.begin(), ratios.end());
      const Difference error = Compare(picture, converged_, 2. / 255);
      const Difference from_double = Compare(picture, exact_.Render(n, 1), 0.5 / 255);
      std::fprintf(out_, "%s,%d x %d,%.3f,%.4f,%.3f,%.5f,%.3f,0\n", name, n, n,
                   ratios[ratios.size() / 2], error.error, error.off, from_double.error,
                   from_double.off);
    }
  }

 private:
  std::vector<Ball> balls_;
  Tracer<double, double, double> exact_;
  std::FILE* out_;
  std::vector<Vec<double>> converged_;
};

}  // namespace

int Main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: precision DATA\n");
    return 2;
  }
  std::FILE* out = std::fopen((std::string(argv[1]) + "/precision.csv").c_str(), "w");
  std::vector<Ball> balls = ReadBalls("scenes/balls5.ray");
  if (out == nullptr || balls.empty()) {
    std::fprintf(stderr, "precision: cannot read scenes/balls5.ray or write to %s\n", argv[1]);
    return 1;
  }
  const Precision precision(std::move(balls), out);
  precision.Measure<double, double, double>("all in double");
  precision.Measure<float, double, double>("boxes in single");
  precision.Measure<float, float, double>("boxes and hits in single");
  precision.Measure<double, double, float>("shading in single");
  precision.Measure<float, float, float>("all in single");
  std::fclose(out);
  return 0;
}

}  // namespace rayshade::bench

int main(int argc, char** argv) { return rayshade::bench::Main(argc, argv); }
