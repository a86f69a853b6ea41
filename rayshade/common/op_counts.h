// Counts of the operations that tracing costs. They are exact and repeatable: tests compare them,
// the cost model of the simulator multiplies them with unit costs.
#pragma once

#include <cstdint>

namespace rayshade {

// X(name): one counter each.
#define RAYSHADE_OP_COUNTS(X)                                                      \
  X(primary_rays)                                                                  \
  X(shadow_rays)                                                                   \
  X(reflected_rays)                                                                \
  X(refracted_rays)                                                                \
  X(hits)        /* rays that hit something and were shaded */                     \
  X(shadow_hits) /* shadow rays that met something */                              \
  X(supersampled_pixels)                                                           \
  X(node_visits)     /* nodes of the hierarchy opened, once per ray (or bundle) */ \
  X(primitive_tests) /* ray against one primitive */                               \
  X(lone_visits)     /* of node_visits: by rays that are not in a bundle */        \
  X(lone_tests)      /* of primitive_tests, likewise */                            \
  X(cell_steps)      /* cells of the subdivision walked through */                 \
  X(cell_tests)      /* ray against the box of a cell on a clip list */            \
  X(cell_traces)     /* hierarchies of fetched cells, once per ray (or bundle) */  \
  X(shades)          /* hits shaded */                                             \
  X(light_samples)   /* lights looked at from a hit */                             \
  X(rays_saved)      /* of shadow_rays: not traced, because no picture shows them */

inline constexpr int kGeomKinds = 14;  // alternatives of GeomSpec

// Of one kind of object.
struct KindCounts {
  uint64_t tests = 0;
  uint64_t hits = 0;  // that were a ray's answer

  KindCounts& operator+=(const KindCounts& o) {
    tests += o.tests;
    hits += o.hits;
    return *this;
  }
  KindCounts& operator-=(const KindCounts& o) {
    tests -= o.tests;
    hits -= o.hits;
    return *this;
  }
};

struct OpCounts {
#define RAYSHADE_DECLARE(name) uint64_t name = 0;
  RAYSHADE_OP_COUNTS(RAYSHADE_DECLARE)
#undef RAYSHADE_DECLARE
  KindCounts kinds[kGeomKinds];  // by GeomSpec::index(); their tests are the primitive_tests

  uint64_t total_rays() const {
    return primary_rays + shadow_rays + reflected_rays + refracted_rays;
  }
  OpCounts& operator+=(const OpCounts& o) {
#define RAYSHADE_ADD(name) name += o.name;
    RAYSHADE_OP_COUNTS(RAYSHADE_ADD)
#undef RAYSHADE_ADD
    for (int i = 0; i < kGeomKinds; ++i) kinds[i] += o.kinds[i];
    return *this;
  }
  // o: counts of the same from before.
  OpCounts& operator-=(const OpCounts& o) {
#define RAYSHADE_SUBTRACT(name) name -= o.name;
    RAYSHADE_OP_COUNTS(RAYSHADE_SUBTRACT)
#undef RAYSHADE_SUBTRACT
    for (int i = 0; i < kGeomKinds; ++i) kinds[i] -= o.kinds[i];
    return *this;
  }
};

}  // namespace rayshade
