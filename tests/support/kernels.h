// The kernels that RAYSHADE_SIMD can ask for. A machine without one runs the next simpler one.
#pragma once

namespace rayshade::test {

inline constexpr const char* kAllKernels[] = {"plain", "avx2", "avx512"};

}  // namespace rayshade::test
