// `make stability`: every primitive's intersection in double precision, this renderer's and the
// textbooks', beside the truth, over the distance of the ray's origin and over the size of the
// object. stability FOLDER [RAYS]: writes FOLDER/stability-distance.csv and
// FOLDER/stability-size.csv and prints a summary.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/stability/measure.h"

namespace rayshade::stability {
namespace {

constexpr int kFirstDecade = -6, kLastDecade = 9;
constexpr double kUsualDistance = 10;

void PrintHead(const char* variable, std::FILE* csv) {
  std::fprintf(csv, "primitive,%s,rays,hits", variable);
  for (const char* which : {"ours", "plain"}) {
    std::fprintf(csv, ",%s_wrong,%s_wrong_counts,%s_misplaced,%s_median,%s_worst", which, which,
                 which, which, which);
  }
  std::fprintf(csv, "\n");
}

void PrintRow(const Subject& subject, double variable, const Measurement& m, std::FILE* csv) {
  std::fprintf(csv, "%s,%g,%d,%d", subject.name.c_str(), variable, m.rays, m.hits);
  for (const Errors& e : {m.ours, m.plain}) {
    std::fprintf(csv, ",%d,%d,%d,%.3g,%.3g", e.wrong, e.wrong_counts, e.misplaced, e.median,
                 e.worst);
  }
  std::fprintf(csv, "\n");
}

int Main(const std::string& folder, int rays) {
  std::FILE* by_distance = std::fopen((folder + "/stability-distance.csv").c_str(), "w");
  std::FILE* by_size = std::fopen((folder + "/stability-size.csv").c_str(), "w");
  if (by_distance == nullptr || by_size == nullptr) {
    std::fprintf(stderr, "stability: cannot write into %s\n", folder.c_str());
    return 1;
  }
  PrintHead("distance", by_distance);
  PrintHead("size", by_size);
  std::printf("%-15s %9s | %8s %8s %9s %9s | %8s %8s %9s %9s\n", "primitive", "distance", "wrong",
              "counts", "misplaced", "worst", "wrong", "counts", "misplaced", "worst");
  for (const Subject& subject : SubjectsOf(1)) {
    for (int decade = kFirstDecade; decade <= kLastDecade; ++decade) {
      const double distance = std::pow(10.0, decade);
      const Measurement m = Measure(subject, 1, distance, rays);
      PrintRow(subject, distance, m, by_distance);
      const auto share = [](int part, int whole) { return whole > 0 ? 100. * part / whole : 0; };
      std::printf("%-15s %9g", subject.name.c_str(), distance);
      for (const Errors& e : {m.ours, m.plain}) {
        std::printf(" | %7.1f%% %7.1f%% %8.1f%% %9.2g", share(e.wrong, m.rays),
                    share(e.wrong_counts, m.rays), share(e.misplaced, m.hits), e.worst);
      }
      std::printf("\n");
    }
  }
  for (int decade = kFirstDecade; decade <= kLastDecade; ++decade) {
    const double size = std::pow(10.0, decade);
    for (const Subject& subject : SubjectsOf(size)) {
      PrintRow(subject, size, Measure(subject, size, kUsualDistance, rays), by_size);
    }
  }
  std::fclose(by_distance);
  std::fclose(by_size);
  return 0;
}

}  // namespace
}  // namespace rayshade::stability

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: stability FOLDER [RAYS]\n");
    return 1;
  }
  return rayshade::stability::Main(argv[1], argc > 2 ? std::atoi(argv[2]) : 1000);
}
