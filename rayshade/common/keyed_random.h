// Random numbers as a function of their key: there is no stream, so that the order of work cannot
// change a picture (DESIGN, exactness 2). The mixing function is the finaliser of splitmix64
// [SLF14].
#pragma once

#include <cstdint>

namespace rayshade {

// What a random number is for; part of its key.
enum class RandomUse : uint32_t {
  kSubCell = 1,  // which sub-cell the first sample of a pixel lies in
  kJitterX,      // place within the sub-cell
  kJitterY,
  kTime,  // moment within the shutter interval
  kLensX,
  kLensY,
  kAreaLight,      // index: 6 * light + component
  kExtendedLight,  // index: 2 * light + component
  kGloss,          // index: 2 * (texture application) + component
  kAnimatedBounds,
  kAreaShare,  // index: area light
};

constexpr uint64_t MixBits(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Key of a sample: seed, frame, pixel of the screen (absolute coordinates; y may be one row below
// the picture), sub-cell within the pixel. Seed and frame can be mixed once for all samples.
constexpr uint64_t FrameKey(uint64_t seed, int frame) {
  return MixBits(MixBits(seed) ^ static_cast<uint32_t>(frame));
}
constexpr uint64_t SampleKey(uint64_t frame_key, int x, int y, int sub_cell) {
  const uint64_t pixel =
      static_cast<uint64_t>(static_cast<uint32_t>(x)) << 32 | static_cast<uint32_t>(y);
  return MixBits(MixBits(frame_key ^ pixel) ^ static_cast<uint32_t>(sub_cell));
}
constexpr uint64_t SampleKey(uint64_t seed, int frame, int x, int y, int sub_cell) {
  return SampleKey(FrameKey(seed, frame), x, y, sub_cell);
}

// Key of a secondary ray's path: its parent's key and whether it is reflected (0) or transmitted
// (1).
constexpr uint64_t PathKey(uint64_t parent, int transmitted) {
  return MixBits(parent ^ (transmitted ? 0x55u : 0xaau));
}

// Uniform in [0, 1), 53 bits.
constexpr double KeyedRandom(uint64_t key, RandomUse use, uint32_t index = 0) {
  const uint64_t bits = MixBits(key ^ MixBits(static_cast<uint64_t>(use) << 32 | index));
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace rayshade
