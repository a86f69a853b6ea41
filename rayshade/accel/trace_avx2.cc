// The kernels of trace.inl compiled for AVX2.
#include <immintrin.h>

#include <cstdint>

#include "rayshade/accel/flat_objects.h"
#include "rayshade/accel/object_set.h"
#include "rayshade/accel/trace_view.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/common/ray.h"

#define RAYSHADE_KERNEL static inline __attribute__((always_inline))
// The larger ones, once each: the compiler takes minutes otherwise.
#define RAYSHADE_ROUTINE static __attribute__((noinline))

namespace rayshade {
namespace {
#include "rayshade/accel/simd_avx2.inl"
#include "rayshade/accel/simd_keys.inl"
#include "rayshade/accel/trace.inl"
}  // namespace

const Kernels kAvx2Kernels = {"avx2", Nearest, Block, BlockRows,  MeetBox,
                              Look,   Aim,     Sort,  AddDiffuse, Shine};

}  // namespace rayshade
