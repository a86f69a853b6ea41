// Reading the command line; see options.h and [rayshade4/1 s.6]. Only the letter after a dash
// counts, options act from left to right, and their arguments are words of their own.
#include "rayshade/scene/options.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "rayshade/common/expression.h"
#include "rayshade/scene/usage.h"

namespace rayshade {
namespace {

// Ends the reading.
struct Stop {
  int status;
};

class Reader {
 public:
  Reader(int argc, const char* const* argv, const std::vector<LongOption>& own)
      : words_(argv, argv + argc), own_(own) {
    if (!words_.empty()) options_.program = words_[0];
  }

  Options Read();

 private:
  [[noreturn]] void Fail(const std::string& text, int status = 2) {
    std::fprintf(stderr, "%s: Fatal error: %s\n", options_.program.c_str(), text.c_str());
    throw Stop{status};
  }
  std::string Word(std::string_view option);
  double Number(std::string_view option);
  int Int(std::string_view option) { return TruncateToInt(Number(option)); }
  Color ThreeNumbers(std::string_view option);

  void ReadShort(const std::string& option);
  bool ReadPicture(char letter, const std::string& option);
  bool ReadRun(char letter, const std::string& option);
  void ReadLong(const std::string& option);
  void ReadReportFile(const std::string& option);
  void ReadInput(const std::string& word);

  std::vector<std::string> words_;
  const std::vector<LongOption>& own_;
  size_t next_ = 1;
  Options options_;
};

std::string Reader::Word(std::string_view option) {
  if (next_ >= words_.size()) {
    Fail("Option " + std::string(option) + " needs an argument; -h tells which.");
  }
  return words_[next_++];
}

double Reader::Number(std::string_view option) {
  const std::string word = Word(option);
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') {
    Fail("Option " + std::string(option) + " needs a number, not \"" + word + "\".");
  }
  return number;
}

Color Reader::ThreeNumbers(std::string_view option) {
  const double r = Number(option), g = Number(option), b = Number(option);
  return {r, g, b};
}

void Reader::ReadShort(const std::string& option) {
  const char letter = option.size() > 1 ? option[1] : '\0';
  if (letter == 'h') {
    PrintUsage(stdout, options_.program, own_);
    throw Stop{0};
  }
  if (!ReadPicture(letter, option) && !ReadRun(letter, option)) Fail("Bad argument: " + option);
}

// Options that change the picture.
bool Reader::ReadPicture(char letter, const std::string& option) {
  Options& o = options_;
  switch (letter) {
    case 'A':
      o.first_frame = Int(option);
      return true;
    case 'C':
      o.cutoff = ThreeNumbers(option);
      return true;
    case 'D':
      o.max_depth = std::max(Int(option), 0);
      return true;
    case 'E':
      o.eye_separation = Number(option);
      return true;
    case 'G':
      o.gamma = Number(option);
      return true;
    case 'N':
      o.frames = Int(option);
      return true;
    case 'R': {
      const int width = Int(option);
      o.resolution = {width, Int(option)};
      return true;
    }
    case 'S':
      o.samples = std::max(Int(option), 1);
      return true;
    case 'T':
      o.contrast = ThreeNumbers(option);
      return true;
    case 'W': {
      Window w;
      for (int* side : {&w.xmin, &w.xmax, &w.ymin, &w.ymax}) *side = Int(option);
      o.window = w;
      return true;
    }
    case 'X': {
      Crop c;
      for (double* side : {&c.left, &c.right, &c.low, &c.high}) *side = Number(option);
      o.crop = c;
      return true;
    }
    case 'f':
      o.flip_normals = !o.flip_normals;
      return true;
    case 'g':
      o.toggle_gauss = !o.toggle_gauss;
      return true;
    case 'j':
      o.jitter = !o.jitter.value_or(true);
      return true;
    case 'l':
      o.stereo = StereoEye::kLeft;
      return true;
    case 'n':
      o.no_shadows = !o.no_shadows;
      return true;
    case 'o':
      o.toggle_shadow_transparency = !o.toggle_shadow_transparency;
      return true;
    case 'p':
      o.no_shadows = true;
      o.max_depth = 0;
      o.jitter = true;
      o.samples = 1;
      return true;
    case 'r':
      o.stereo = StereoEye::kRight;
      return true;
    default:
      return false;
  }
}

// Options about input, output and the course of the run.
bool Reader::ReadRun(char letter, const std::string& option) {
  Options& o = options_;
  switch (letter) {
    case 'F':
      o.report_frequency = std::max(Int(option), 1);
      return true;
    case 'O':
      o.output = Word(option);
      return true;
    case 'P':
      o.preprocessor_arguments = {Word(option)};
      return true;
    case 'V':
      ReadReportFile(option);
      return true;
    case 'a':
      o.alpha = !o.alpha;
      return true;
    case 'c':
      o.continue_picture = true;
      return true;
    case 'e':
      return true;  // exponent-coded files are not written
    case 'm':
      o.sample_map = !o.sample_map;
      return true;
    case 'q':
      o.quiet = true;
      return true;
    case 's':
      return true;  // there is no shadow cache
    case 'u':
      o.raw_input = !o.raw_input;
      return true;
    case 'v':
      o.verbose = true;
      return true;
    default:
      return false;
  }
}

void Reader::ReadReportFile(const std::string& option) {
  options_.report_file = Word(option);
  options_.verbose = true;
  if (options_.report_file.starts_with('-')) {
    PrintUsage(stderr, options_.program, own_);
    throw Stop{2};
  }
}

// --name, --name=value or --name value.
void Reader::ReadLong(const std::string& option) {
  const size_t equals = option.find('=');
  const std::string name = option.substr(2, equals == std::string::npos ? equals : equals - 2);
  const std::string dashed = "--" + name;
  const std::vector<LongOption> known = AllLongOptions(own_);
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&name](const LongOption& o) { return name == o.name; });
  if (name.empty() || found == known.end()) Fail("Bad argument: " + option);
  const std::string_view argument = found->argument;

  // Its value.
  std::string value;
  if (equals != std::string::npos) {
    if (argument.empty()) Fail("Option " + dashed + " takes no value.");
    value = option.substr(equals + 1);
  } else if (!argument.empty() && !argument.ends_with('?')) {
    value = Word(dashed);
  }

  // Those that all programs share.
  if (name == "help") {
    PrintUsage(stdout, options_.program, own_);
    throw Stop{0};
  } else if (name == "seed") {
    char* end = nullptr;
    options_.seed = std::strtoull(value.c_str(), &end, 10);
    if (value.empty() || value[0] < '0' || value[0] > '9' || *end != '\0') {
      Fail("Option --seed needs a whole number from 0, not \"" + value + "\".");
    }
  } else if (name == "quality") {
    const std::optional<Quality> quality = QualityNamed(value);
    if (!quality) {
      Fail("Option --quality needs draft, rayshade, fine or reference, not \"" + value + "\".");
    }
    options_.quality = *quality;
  } else if (name == "stats") {
    options_.stats_file = value;
  } else {
    options_.extra.emplace_back(name, value);
  }
}

void Reader::ReadInput(const std::string& word) {
  if (!options_.input.empty()) {
    std::fprintf(stderr, "%s: more than one file name: %s and %s\n", options_.program.c_str(),
                 options_.input.c_str(), word.c_str());
    PrintUsage(stderr, options_.program, own_);
    throw Stop{1};
  }
  options_.input = word;
}

Options Reader::Read() {
  while (next_ < words_.size()) {
    const std::string word = words_[next_++];
    if (word.starts_with("--")) {
      ReadLong(word);
    } else if (word.starts_with("-")) {
      ReadShort(word);
    } else {
      ReadInput(word);
    }
  }
  return options_;
}

}  // namespace

OptionsResult ParseOptions(int argc, const char* const* argv, const std::vector<LongOption>& own) {
  try {
    return {Reader(argc, argv, own).Read(), 0};
  } catch (const Stop& stop) {
    return {std::nullopt, stop.status};
  }
}

}  // namespace rayshade
