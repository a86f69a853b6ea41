// The command line, as far as all programs share it [rayshade4/1 s.6.2]. Long options that only one
// program has are left in `extra` for it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rayshade/common/color.h"
#include "rayshade/scene/quality.h"
#include "rayshade/scene/settings.h"

namespace rayshade {

// What was said on the command line and nothing else: unset members leave the word to the file.
struct Options {
  std::string program;                              // argv[0]
  std::string input;                                // "": standard input
  std::optional<std::string> output;                // -O
  std::optional<std::pair<int, int>> resolution;    // -R
  std::optional<int> max_depth;                     // -D
  std::optional<Color> cutoff;                      // -C
  std::optional<int> samples;                       // -S
  std::optional<Color> contrast;                    // -T
  std::optional<bool> jitter;                       // -j, -p
  std::optional<Window> window;                     // -W
  std::optional<Crop> crop;                         // -X
  std::optional<double> eye_separation;             // -E
  StereoEye stereo = StereoEye::kNone;              // -l -r
  std::optional<int> first_frame;                   // -A
  std::optional<int> frames;                        // -N
  std::optional<int> report_frequency;              // -F
  std::optional<double> gamma;                      // -G
  bool toggle_gauss = false;                        // -g, before the file is read
  bool flip_normals = false;                        // -f
  bool no_shadows = false;                          // -n, -p
  bool toggle_shadow_transparency = false;          // -o
  bool alpha = false;                               // -a
  bool sample_map = false;                          // -m
  bool continue_picture = false;                    // -c
  bool raw_input = false;                           // -u
  std::vector<std::string> preprocessor_arguments;  // -P
  bool verbose = false;                             // -v, -V
  std::string report_file;                          // -V
  bool quiet = false;                               // -q
  uint64_t seed = 1;                                // --seed
  Quality quality = Quality::kRayshade;             // --quality
  std::string stats_file;                           // --stats
  std::vector<std::pair<std::string, std::string>>
      extra;  // long options of one program: name, value
};

// A program's own long options: name, "" or the argument's name (ending in "?" where it may be left
// out), help line.
struct LongOption {
  const char* name;
  const char* argument;
  const char* help;
};

struct OptionsResult {
  std::optional<Options> options;  // none: stop with `status`
  int status = 0;
};

// Prints usage (-h, --help; standard output, status 0) or what is wrong (standard error, status 1
// or 2).
OptionsResult ParseOptions(int argc, const char* const* argv, const std::vector<LongOption>& own);

}  // namespace rayshade
