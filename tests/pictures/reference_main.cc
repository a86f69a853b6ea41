// make reference: renders the reference scenes and compares with the original's pictures, one line
// for each scene and a summary. Usage: compare_reference PROGRAM FOLDER WORK [--seeds N] [NAME...]
//
//   FOLDER   manifest.tsv, NAME.ray, NAME.png; jitter-* also NAME.mean.png and NAME.sd.png
//   WORK     where the pictures go
//   bar      99.9% of pixels within 1/255 and a mean difference of at most 0.05/255; for jitter-*,
//   over N seeds
//            (100), the mean within the noise of the original's on 99.9% of pixels, the deviation
//            within 5%, the ray counts within 2%
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "rayshade/image/png.h"

namespace {

using rayshade::ImageData;
using rayshade::ReadPng;

struct Scene {
  std::string name, command;
  long long rays[4] = {};  // eye, shadow, reflected, refracted
  bool random() const { return name.rfind("jitter", 0) == 0; }
};

struct Paths {
  std::string program, folder, work;
};

std::vector<std::string> Split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

std::vector<Scene> ReadManifest(const std::string& folder) {
  std::ifstream in(folder + "/manifest.tsv");
  std::vector<Scene> scenes;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const std::vector<std::string> columns = Split(line, '\t');
    if (columns.size() < 9) continue;
    Scene scene{columns[0], columns[1]};
    for (int i = 0; i < 4; ++i) scene.rays[i] = std::atoll(columns[5 + i].c_str());
    scenes.push_back(scene);
  }
  return scenes;
}

// The original's command line with our program, output and statistics. Returns its exit status.
int Render(const Paths& paths, const Scene& scene, const std::string& options) {
  std::string line;
  for (const std::string& word : Split(scene.command, ' ')) {
    const bool output = word.size() > 4 && word.compare(word.size() - 4, 4, ".ppm") == 0;
    line += word == "rayshade4-ref"
                ? "'" + paths.program + "' -q --stats '" + paths.work + "/stats.json' " + options
            : output ? "'" + paths.work + "/" + scene.name + ".png'"
                     : word;
    line += " ";
  }
  std::remove((paths.work + "/" + scene.name + ".png").c_str());
  std::remove((paths.work + "/stats.json").c_str());
  const std::string command =
      "cd '" + paths.folder + "' && " + line + " 2>'" + paths.work + "/messages' >/dev/null";
  return std::system(command.c_str());
}

bool ReadRays(const Paths& paths, long long rays[4]) {
  std::ifstream in(paths.work + "/stats.json");
  const std::string json{std::istreambuf_iterator<char>(in), {}};
  const size_t at = json.find("\"rays\":");
  return at != std::string::npos &&
         std::sscanf(json.c_str() + at,
                     "\"rays\":{\"primary\":%lld,\"shadow\":%lld,\"reflected\":%lld,"
                     "\"refracted\":%lld",
                     &rays[0], &rays[1], &rays[2], &rays[3]) == 4;
}

std::string RayColumns(const long long ours[4], const long long theirs[4]) {
  const char* names[4] = {"eye", "shadow", "reflected", "refracted"};
  std::string text;
  for (int i = 0; i < 4; ++i) {
    if (ours[i] == 0 && theirs[i] == 0) continue;
    char column[80];
    std::snprintf(column, sizeof column, ours[i] == theirs[i] ? "  %s %lld" : "  %s %lld (%lld)",
                  names[i], ours[i], theirs[i]);
    text += column;
  }
  return text;
}

struct Verdict {
  bool passes = false, identical = false;
};

// One line: share of pixels within 1/255, mean difference, worst pixel, identical or not, rays (the
// original's in brackets where they differ).
Verdict Compare(const Paths& paths, const Scene& scene) {
  const int status = Render(paths, scene, "");
  ImageData ours, theirs = ReadPng(paths.folder + "/" + scene.name + ".png");
  try {
    ours = ReadPng(paths.work + "/" + scene.name + ".png");
  } catch (const std::runtime_error&) {
    std::ifstream in(paths.work + "/messages");
    std::string message;
    std::getline(in, message);
    std::printf("FAIL  %-28s no picture, status %d: %s\n", scene.name.c_str(), status,
                message.c_str());
    return {};
  }
  if (ours.color.size() != theirs.color.size() || ours.width != theirs.width) {
    std::printf("FAIL  %-28s size %d x %d\n", scene.name.c_str(), ours.width, ours.height);
    return {};
  }
  size_t within = 0;
  double sum = 0;
  int worst = 0;
  size_t worst_at = 0;
  for (size_t i = 0; i < ours.color.size(); i += 3) {
    int largest = 0;
    for (size_t c = i; c < i + 3; ++c) {
      const int difference = std::abs(int(ours.color[c]) - int(theirs.color[c]));
      sum += difference;
      largest = std::max(largest, difference);
    }
    within += largest <= 1;
    if (largest > worst) {
      worst = largest;
      worst_at = i / 3;
    }
  }
  const double share = double(within) / (ours.color.size() / 3), mean = sum / ours.color.size();
  Verdict verdict{share >= .999 && mean <= .05, worst == 0};
  long long rays[4] = {};
  ReadRays(paths, rays);
  const int x = static_cast<int>(worst_at % ours.width);
  const int y = ours.height - 1 - static_cast<int>(worst_at / ours.width);
  std::printf("%s  %-28s %8.4f%%  mean %.4f  worst %3d at %d %d%s%s\n",
              verdict.passes ? "ok  " : "FAIL", scene.name.c_str(), share * 100, mean, worst, x, y,
              verdict.identical ? "  identical" : "", RayColumns(rays, scene.rays).c_str());
  return verdict;
}

// Over many seeds: mean and deviation of every byte against the original's.
Verdict CompareRandom(const Paths& paths, const Scene& scene, int seeds) {
  const ImageData mean = ReadPng(paths.folder + "/" + scene.name + ".mean.png");
  const ImageData deviation = ReadPng(paths.folder + "/" + scene.name + ".sd.png");
  const size_t bytes = mean.color.size();
  std::vector<double> sum(bytes), squares(bytes);
  long long rays[4] = {};
  for (int seed = 1; seed <= seeds; ++seed) {
    Render(paths, scene, "--seed " + std::to_string(seed));
    const ImageData picture = ReadPng(paths.work + "/" + scene.name + ".png");
    if (picture.color.size() != bytes) throw std::runtime_error(scene.name + ": another size");
    for (size_t i = 0; i < bytes; ++i) {
      sum[i] += picture.color[i];
      squares[i] += double(picture.color[i]) * picture.color[i];
    }
    long long of_seed[4] = {};
    ReadRays(paths, of_seed);
    for (int i = 0; i < 4; ++i) rays[i] += of_seed[i];
  }

  size_t within = 0;
  double our_variance = 0, their_variance = 0;
  for (size_t i = 0; i < bytes; i += 3) {
    bool pixel_within = true;
    for (size_t c = i; c < i + 3; ++c) {
      const double m = sum[c] / seeds, s = deviation.color[c];
      our_variance += std::max(0.0, squares[c] / seeds - m * m);
      their_variance += s * s;
      pixel_within &=
          std::fabs(m - mean.color[c]) <= 1 + 4 * std::max(s, .5) * std::sqrt(2. / seeds);
    }
    within += pixel_within;
  }
  our_variance *= .99 * seeds / std::max(1, seeds - 1);  // as if over the original's 100 runs
  const double share = double(within) / (bytes / 3);
  const double ours = std::sqrt(our_variance / bytes), theirs = std::sqrt(their_variance / bytes);
  bool rays_alike = true;
  for (int i = 0; i < 4; ++i) {
    rays[i] /= seeds;
    rays_alike &= std::llabs(rays[i] - scene.rays[i]) <= .02 * scene.rays[i] + 20;
  }
  Verdict verdict{share >= .999 && std::fabs(ours - theirs) <= .05 * theirs + .1 && rays_alike,
                  false};
  std::printf("%s  %-28s %8.4f%%  deviation %.3f (%.3f)%s\n", verdict.passes ? "ok  " : "FAIL",
              scene.name.c_str(), share * 100, ours, theirs, RayColumns(rays, scene.rays).c_str());
  return verdict;
}

int Run(const Paths& paths, int seeds, const std::vector<std::string>& names) {
  int scenes = 0, passed = 0, identical = 0, random = 0, random_passed = 0;
  for (const Scene& scene : ReadManifest(paths.folder)) {
    if (!names.empty() && std::find(names.begin(), names.end(), scene.name) == names.end())
      continue;
    if (scene.random()) {
      if (seeds == 0) continue;
      ++random;
      random_passed += CompareRandom(paths, scene, seeds).passes;
      continue;
    }
    ++scenes;
    const Verdict verdict = Compare(paths, scene);
    passed += verdict.passes;
    identical += verdict.identical;
  }
  std::printf(
      "%d of %d deterministic scenes within the bar, %d byte-identical; %d of %d random ones\n",
      passed, scenes, identical, random_passed, random);
  return passed == scenes && random_passed == random ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s PROGRAM FOLDER WORK [--seeds N] [NAME...]\n", argv[0]);
    return 2;
  }
  int seeds = 100;
  std::vector<std::string> names;
  for (int i = 4; i < argc; ++i) {
    if (std::strcmp(argv[i], "--seeds") == 0 && i + 1 < argc) {
      seeds = std::atoi(argv[++i]);
    } else {
      names.push_back(argv[i]);
    }
  }
  try {
    return Run({argv[1], argv[2], argv[3]}, seeds, names);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
