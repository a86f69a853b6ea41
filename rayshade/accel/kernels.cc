// Which instruction set's kernels run; see trace_view.h.
#include <cstdlib>
#include <cstring>

#include "rayshade/accel/trace_view.h"

namespace rayshade {

const Kernels& ChooseKernels() {
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                        __builtin_cpu_supports("bmi2");
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  const char* wanted = std::getenv("RAYSHADE_SIMD");
  const auto allowed = [&](const Kernels& kernels) {
    return wanted == nullptr || std::strcmp(wanted, kernels.name) == 0;
  };
  if (has_avx512 && allowed(kAvx512Kernels)) return kAvx512Kernels;
  if (has_avx2 && allowed(kAvx2Kernels)) return kAvx2Kernels;
  if (wanted != nullptr && std::strcmp(wanted, "avx512") == 0 && has_avx2) return kAvx2Kernels;
  return kPlainKernels;
}

}  // namespace rayshade
