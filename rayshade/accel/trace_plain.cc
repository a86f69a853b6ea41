// The kernels of trace.inl compiled without vector instructions in particular.

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
#include "rayshade/accel/simd_plain.inl"
#include "rayshade/accel/trace.inl"
}  // namespace

const Kernels kPlainKernels = {"plain", Nearest, Block, BlockRows,  MeetBox,
                               Look,    Aim,     Sort,  AddDiffuse, Shine};

}  // namespace rayshade
