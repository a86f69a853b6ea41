// sphereflake SIZE: the balls of the Standard Procedural Databases [SPD] in the Rayshade language,
// on standard output.
//
// A ball of radius 1/2 at the origin carries nine balls of a third of its radius, where nine equal
// balls touch a tenth in a close packing: six round its waist, three towards its top; each of them
// does the same, SIZE times over. Size n has (9^(n+1) - 1) / 8 balls. With --paper the scene is the
// one that [RJ s.5] renders: no plane, one light, the ten largest balls not reflective. The balls
// are written as they are made, so any size fits into memory.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string>

namespace {

struct Vector {
  double x, y, z;
};

struct Options {
  int size = -1;
  int lights = 1;
  int grid = -1;  // cells along an edge; 0: no grid; -1: chosen by the number of balls
  bool plane = false;
  bool dull_ten = false;
};

constexpr char kUsage[] =
    "usage: sphereflake SIZE [OPTION]...\n"
    "Writes a flake of (9^(SIZE+1) - 1) / 8 balls in the Rayshade language to standard output.\n"
    "  --lights 1|3   point lights (default 1)\n"
    "  --plane        a square of ground under the balls\n"
    "  --dull         the ten largest balls are not reflective\n"
    "  --paper        as Reinhard and Jansen render it: one light, no plane, the ten largest dull\n"
    "  --grid N       balls in a grid of N x N x N cells (0: in none; default: by SIZE)\n"
    "  --help         this text\n";

double BallCount(int size) { return (std::pow(9.0, size + 1) - 1) / 8; }

// Where a ball that grows along +z carries its nine children, as unit vectors from its centre.
std::array<Vector, 9> ChildDirections() {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double top_height = std::sqrt(2.0 / 3), top_reach = std::sqrt(1.0 / 3);
  std::array<Vector, 9> directions;
  for (int i = 0; i < 6; ++i) {
    const double angle = kTurn * (1.0 / 24 + i / 6.0);
    directions[i] = {std::cos(angle), std::sin(angle), 0};
  }
  for (int i = 0; i < 3; ++i) {
    const double angle = kTurn * (1.0 / 8 + i / 3.0);
    directions[6 + i] = {top_reach * std::cos(angle), top_reach * std::sin(angle), top_height};
  }
  return directions;
}

// v after the shortest rotation that takes +z to `axis` (a unit vector); about y where the two are
// opposite.
Vector TurnedTo(const Vector& axis, const Vector& v) {
  if (axis.z <= -1 + 1e-12) return {-v.x, v.y, -v.z};
  const double along = (axis.x * v.x + axis.y * v.y) / (1 + axis.z);
  return {v.x + axis.x * (v.z - along), v.y + axis.y * (v.z - along),
          axis.z * v.z - axis.x * v.x - axis.y * v.y};
}

class FlakeWriter {
 public:
  explicit FlakeWriter(const Options& options) : options_(options) { line_.reserve(128); }

  void WriteScene() {
    WriteView();
    const int grid = options_.grid >= 0 ? options_.grid : ChosenGrid();
    if (grid > 0) std::printf("grid %d %d %d\n", grid, grid, grid);
    std::printf("applysurf shiny\n");
    WriteBalls(0, {0, 0, 0}, 0.5, {0, 0, 1});
    if (grid > 0) std::printf("end\n");
    if (options_.plane) {
      std::printf("polygon ground 12 12 -.5  -12 12 -.5  -12 -12 -.5  12 -12 -.5\n");
    }
  }

 private:
  int ChosenGrid() const {
    return static_cast<int>(std::min(200.0, std::ceil(1.5 * std::cbrt(BallCount(options_.size)))));
  }

  void WriteView() const {
    std::printf("/* Haines' balls, size %d: %.0f spheres. Made by sphereflake. */\n", options_.size,
                BallCount(options_.size));
    std::printf(
        "background .078 .361 .753\neyep 2.1 1.3 1.7\nlookp 0 0 0\nup 0 0 1\nfov 45 45\n"
        "screen 256 256\nsample 1 nojitter\ncontrast 1 1 1\n");
    if (options_.lights == 1) {
      std::printf("light 1 point 4 3 2\n");
    } else {
      std::printf(
          "light .57735 point 4 3 2\nlight .57735 point 1 -4 4\nlight .57735 point -3 1 5\n");
    }
    constexpr char kBall[] = "ambient 0 0 0 diffuse .5 .45 .35 specular .5 .5 .5 specpow 3.0827";
    if (options_.dull_ten) std::printf("surface dull %s\n", kBall);
    std::printf("surface shiny %s reflect .5\n", kBall);
    if (options_.plane) std::printf("surface ground ambient .2 .15 .066 diffuse .8 .6 .264\n");
  }

  void WriteBalls(int level, const Vector& centre, double radius, const Vector& direction) {
    WriteBall(options_.dull_ten && level <= 1, radius, centre);
    if (level == options_.size) return;
    const double reach = radius * 4 / 3;
    for (const Vector& child : directions_) {
      const Vector d = TurnedTo(direction, child);
      WriteBalls(level + 1,
                 {centre.x + reach * d.x, centre.y + reach * d.y, centre.z + reach * d.z},
                 radius / 3, d);
    }
  }

  void WriteBall(bool dull, double radius, const Vector& centre) {
    line_ = dull ? "sphere dull" : "sphere";
    for (const double number : {radius, centre.x, centre.y, centre.z}) Append(number);
    line_ += '\n';
    std::fwrite(line_.data(), 1, line_.size(), stdout);
  }

  // Six significant digits, without the zero before the point.
  void Append(double number) {
    if (std::abs(number) < 1e-12) number = 0;
    char digits[32];
    const char* end =
        std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 6).ptr;
    const char* begin = digits;
    line_ += ' ';
    if (*begin == '-') line_ += *begin++;
    if (end - begin > 1 && begin[0] == '0' && begin[1] == '.') ++begin;
    line_.append(begin, end);
  }

  const Options options_;
  const std::array<Vector, 9> directions_ = ChildDirections();
  std::string line_;
};

// A whole number from `low` to `high`, or -1.
int ParseInt(const char* text, int low, int high) {
  int value = -1;
  const char* end = text + std::strlen(text);
  const auto result = std::from_chars(text, end, value);
  return result.ec == std::errc() && result.ptr == end && value >= low && value <= high ? value
                                                                                        : -1;
}

// False where the arguments make no sense.
bool ParseArguments(int argc, char** argv, Options* options) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (argument == "--plane") {
      options->plane = true;
    } else if (argument == "--dull") {
      options->dull_ten = true;
    } else if (argument == "--paper") {
      options->plane = false;
      options->lights = 1;
      options->dull_ten = true;
    } else if (argument == "--lights") {
      options->lights = ParseInt(value, 1, 3);
      if (options->lights != 1 && options->lights != 3) return false;
      ++i;
    } else if (argument == "--grid") {
      options->grid = ParseInt(value, 0, 1000);
      if (options->grid < 0) return false;
      ++i;
    } else {
      if (options->size >= 0) return false;
      options->size = ParseInt(argv[i], 0, 12);
      if (options->size < 0) return false;
    }
  }
  return options->size >= 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--help") == 0) {
    std::fputs(kUsage, stdout);
    return 0;
  }
  Options options;
  if (!ParseArguments(argc, argv, &options)) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  FlakeWriter(options).WriteScene();
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    std::perror("sphereflake");
    return 1;
  }
  return 0;
}
