// Probing the C library; see math_probe.h.
#include "parallel/math_probe.h"

#include <bit>
#include <cmath>

#include "rayshade/common/keyed_random.h"

namespace rayshade::parallel {

uint64_t MathProbe() {
  uint64_t hash = 0;
  const auto add = [&hash](double value) { hash = MixBits(hash ^ std::bit_cast<uint64_t>(value)); };
  for (uint32_t i = 0; i < 400; ++i) {
    const volatile double a =
        KeyedRandom(1, RandomUse::kJitterX, i);  // volatile: not folded by the compiler
    const volatile double b = 40 * KeyedRandom(2, RandomUse::kJitterX, i);
    const double x = a, y = b;
    add(std::pow(x, y));
    add(std::exp(-y));
    add(std::log(y));
    add(std::sin(y));
    add(std::cos(y));
    add(std::tan(x));
    add(std::acos(x));
    add(std::asin(x));
    add(std::atan(y));
    add(std::cbrt(y));
    add(std::hypot(x, y));
  }
  return hash;
}

}  // namespace rayshade::parallel
