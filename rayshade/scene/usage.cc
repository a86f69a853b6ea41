// The help text; see usage.h and [rayshade4/1 s.2.8, 6.2].
#include "rayshade/scene/usage.h"

namespace rayshade {
namespace {

struct Line {
  const char* option;  // "": a headline
  const char* help;
};

constexpr Line kShortOptions[] = {
    {"", "Input and output"},
    {"-O FILE", "output file, a PNG; - is standard output  [rays.png]"},
    {"-u", "do not send the input through the C preprocessor"},
    {"-P ARGUMENTS", "arguments for the C preprocessor, such as -P \"-DCOUNT=3 -Iparts\""},
    {"-c", "continue a picture that was cut short"},
    {"-a", "add an alpha channel: how much of a pixel is covered by objects"},
    {"-m", "alpha is the sample map: where pixels were supersampled"},
    {"-G GAMMA", "gamma of the display  [1]"},
    {"", "Size and part of the picture"},
    {"-R WIDTH HEIGHT", "resolution of the screen  [screen, 512 512]"},
    {"-W XMIN XMAX YMIN YMAX", "render only this window of the screen, in pixels"},
    {"-X LEFT RIGHT LOW HIGH", "render only this part of the window, in fractions from 0 to 1"},
    {"-E DISTANCE", "distance between the eyes, for -l and -r"},
    {"-l, -r", "picture for the left or the right eye"},
    {"-A FRAME", "number of the first frame  [0]"},
    {"-N FRAMES", "number of frames  [frames, 1]"},
    {"", "Quality"},
    {"-S N", "at most N x N samples per pixel, 1 to 8  [sample, 3]"},
    {"-T R G B", "contrast above which a pixel is supersampled  [contrast, .2 .15 .3]"},
    {"-j", "toggle jitter  [on]"},
    {"-g", "toggle the Gaussian filter; a filter statement in the file wins"},
    {"-D DEPTH", "longest chain of reflections and refractions  [maxdepth, 5]"},
    {"-C R G B", "rays that contribute less are not traced  [cutoff, .002 .002 .002]"},
    {"-n", "toggle shadows"},
    {"-o", "toggle light through transparent objects"},
    {"-f", "flip the normals of triangles and polygons"},
    {"-p", "preview: one sample, no shadows, no reflections"},
    {"", "Report"},
    {"-v", "verbose"},
    {"-V FILE", "verbose, with the report in FILE"},
    {"-F LINES", "report progress every so many lines  [10]"},
    {"-q", "no advice, no progress"},
    {"-e, -s", "accepted and without effect"},
    {"-h", "this help"},
};

void PrintLine(std::FILE* stream, const std::string& option, const char* help) {
  std::fprintf(stream, "\t%-24s %s\n", option.c_str(), help);
}

void PrintExamples(std::FILE* stream, const char* program) {
  std::fprintf(stream, "\nExamples:\n");
  std::fprintf(stream, "\t%s -O room.png room.ray\n", program);
  std::fprintf(stream, "\t%s -p -R 160 120 -O quick.png room.ray\n", program);
  std::fprintf(stream,
               "\techo 'light 1 point 3 -4 5 sphere diffuse .9 .3 .2 2 0 0 0' | %s -O ball.png\n",
               program);
}

}  // namespace

std::vector<LongOption> AllLongOptions(const std::vector<LongOption>& own) {
  std::vector<LongOption> all{
      {"help", "", "this help"},
      {"quality", "NAME", "draft, rayshade, fine or reference  [rayshade: as the file says]"},
      {"seed", "N", "seed of the picture's random numbers  [1]"},
      {"stats", "FILE", "write times and counts to FILE, as JSON"},
  };
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

void PrintUsage(std::FILE* stream, const std::string& program, const std::vector<LongOption>& own) {
  std::fprintf(stream, "usage: %s [options] [filename]\n", program.c_str());
  std::fprintf(stream, "Where options include:\n");
  for (const Line& line : kShortOptions) {
    if (*line.option == '\0') {
      std::fprintf(stream, "\n    %s\n", line.help);
    } else {
      PrintLine(stream, line.option, line.help);
    }
  }
  std::fprintf(stream, "\n    Long options (--name VALUE or --name=VALUE)\n");
  for (const LongOption& option : AllLongOptions(own)) {
    std::string argument = option.argument;
    const bool optional = argument.ends_with('?');
    if (optional) argument.pop_back();
    std::string text = std::string("--") + option.name;
    if (!argument.empty()) text += optional ? "[=" + argument + "]" : " " + argument;
    PrintLine(stream, text, option.help);
  }
  std::fprintf(
      stream,
      "\nIn [ ]: the word of the scene file that says the same, and the default. Without a "
      "file name the scene is\nread from standard input. Options may stand in any order, "
      "each as a word of its own.\n");
  PrintExamples(stream, program.c_str());
}

}  // namespace rayshade
