// Part of `make stability`: how many rays that leave a surface meet it where they begin.
// spawned FOLDER [OBJECTS [RAYS]]: prints a table and writes it to
// FOLDER/stability-spawned.csv.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/stability/spawned.h"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: spawned FOLDER [OBJECTS [RAYS]]\n");
    return 1;
  }
  const std::string path = std::string(argv[1]) + "/stability-spawned.csv";
  std::FILE* csv = std::fopen(path.c_str(), "w");
  if (csv == nullptr) {
    std::fprintf(stderr, "spawned: cannot write %s\n", path.c_str());
    return 1;
  }
  const int objects = argc > 2 ? std::atoi(argv[2]) : 1000;
  const int rays = argc > 3 ? std::atoi(argv[3]) : 10000;
  std::fprintf(csv, "primitive,objects,rays,hits,own,own_by_fixed_epsilon,at_edges\n");
  std::printf("%-15s %8s %10s %10s %10s %16s %9s\n", "primitive", "objects", "rays", "hits again",
              "own origin", "by fixed epsilon", "at edges");
  int64_t own = 0;
  for (const auto& c : rayshade::stability::CountOwnHits(objects, rays)) {
    std::fprintf(csv, "%s,%d,%" PRId64 ",%" PRId64 ",%" PRId64 ",%" PRId64 ",%" PRId64 "\n",
                 c.primitive.c_str(), c.objects, c.rays, c.hits, c.own, c.own_by_original,
                 c.at_edges);
    std::printf("%-15s %8d %10" PRId64 " %10" PRId64 " %10" PRId64 " %16" PRId64 " %9" PRId64 "\n",
                c.primitive.c_str(), c.objects, c.rays, c.hits, c.own, c.own_by_original,
                c.at_edges);
    own += c.own;
  }
  std::fclose(csv);
  return own == 0 ? 0 : 1;
}
