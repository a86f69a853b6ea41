// Eight floats and eight doubles without any instruction set in particular. The three simd_*.inl
// define the same types and functions; the kernels (trace.inl) are written on top of them.
// Comparisons give one bit per lane. Min and Max return the second argument where one is not a
// number.
struct F8 {
  float v[8];
};
struct D8 {
  double v[8];
};

#define RAYSHADE_LANES for (int i = 0; i < 8; ++i)

RAYSHADE_KERNEL F8 LoadF(const float* p) {
  F8 r;
  RAYSHADE_LANES r.v[i] = p[i];
  return r;
}
RAYSHADE_KERNEL F8 SetF(float x) {
  F8 r;
  RAYSHADE_LANES r.v[i] = x;
  return r;
}
RAYSHADE_KERNEL void Store(F8 a, float* p) { RAYSHADE_LANES p[i] = a.v[i]; }
RAYSHADE_KERNEL F8 operator-(F8 a, F8 b) {
  F8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] - b.v[i];
  return r;
}
RAYSHADE_KERNEL F8 operator*(F8 a, F8 b) {
  F8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] * b.v[i];
  return r;
}
RAYSHADE_KERNEL F8 Min(F8 a, F8 b) {
  F8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
  return r;
}
RAYSHADE_KERNEL F8 Max(F8 a, F8 b) {
  F8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
  return r;
}
RAYSHADE_KERNEL uint32_t LessEqual(F8 a, F8 b) {
  uint32_t r = 0;
  RAYSHADE_LANES r |= static_cast<uint32_t>(a.v[i] <= b.v[i]) << i;
  return r;
}

RAYSHADE_KERNEL F8 operator/(F8 a, F8 b) {
  F8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] / b.v[i];
  return r;
}
RAYSHADE_KERNEL F8 Size(F8 a) {
  F8 r;
  RAYSHADE_LANES r.v[i] = __builtin_fabsf(a.v[i]);
  return r;
}
RAYSHADE_KERNEL uint32_t Less(F8 a, F8 b) {
  uint32_t r = 0;
  RAYSHADE_LANES r |= static_cast<uint32_t>(a.v[i] < b.v[i]) << i;
  return r;
}

RAYSHADE_KERNEL D8 LoadD(const double* p) {
  D8 r;
  RAYSHADE_LANES r.v[i] = p[i];
  return r;
}
RAYSHADE_KERNEL D8 SetD(double x) {
  D8 r;
  RAYSHADE_LANES r.v[i] = x;
  return r;
}
RAYSHADE_KERNEL void Store(D8 a, double* p) { RAYSHADE_LANES p[i] = a.v[i]; }
RAYSHADE_KERNEL D8 operator+(D8 a, D8 b) {
  D8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] + b.v[i];
  return r;
}
RAYSHADE_KERNEL D8 operator-(D8 a, D8 b) {
  D8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] - b.v[i];
  return r;
}
RAYSHADE_KERNEL D8 operator*(D8 a, D8 b) {
  D8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] * b.v[i];
  return r;
}
RAYSHADE_KERNEL D8 operator/(D8 a, D8 b) {
  D8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] / b.v[i];
  return r;
}
RAYSHADE_KERNEL D8 Sqrt(D8 a) {
  D8 r;
  RAYSHADE_LANES r.v[i] = __builtin_sqrt(a.v[i]);
  return r;
}
RAYSHADE_KERNEL uint32_t LessEqual(D8 a, D8 b) {
  uint32_t r = 0;
  RAYSHADE_LANES r |= static_cast<uint32_t>(a.v[i] <= b.v[i]) << i;
  return r;
}
RAYSHADE_KERNEL uint32_t Less(D8 a, D8 b) {
  uint32_t r = 0;
  RAYSHADE_LANES r |= static_cast<uint32_t>(a.v[i] < b.v[i]) << i;
  return r;
}
// a where the bit is set, b elsewhere.
RAYSHADE_KERNEL D8 Choose(uint32_t mask, D8 a, D8 b) {
  D8 r;
  RAYSHADE_LANES r.v[i] = (mask >> i & 1) ? a.v[i] : b.v[i];
  return r;
}
RAYSHADE_KERNEL F8 operator+(F8 a, F8 b) {
  F8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] + b.v[i];
  return r;
}
RAYSHADE_KERNEL D8 Min(D8 a, D8 b) {
  D8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
  return r;
}
RAYSHADE_KERNEL D8 Max(D8 a, D8 b) {
  D8 r;
  RAYSHADE_LANES r.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
  return r;
}
RAYSHADE_KERNEL F8 Choose(uint32_t mask, F8 a, F8 b) {
  F8 r;
  RAYSHADE_LANES r.v[i] = (mask >> i & 1) ? a.v[i] : b.v[i];
  return r;
}
// Keys of lanes, by which the least is found: of those with a <= b the upper 16 bits of a, which is
// positive; the others have none, which is 0xffff. keys: aligned to 16 bytes.
RAYSHADE_KERNEL void StoreKeys(F8 a, F8 b, uint16_t* keys) {
  RAYSHADE_LANES {
    const uint32_t bits = __builtin_bit_cast(uint32_t, a.v[i]);
    keys[i] = a.v[i] <= b.v[i] ? static_cast<uint16_t>(bits >> 16) : 0xffff;
  }
}
// Those of the keys that are not larger than that of `most`, which is positive; bits.
RAYSHADE_KERNEL uint32_t KeepKeys(const uint16_t* keys, float most, uint16_t* kept) {
  const uint32_t limit = __builtin_bit_cast(uint32_t, most) >> 16;
  uint32_t bits = 0;
  RAYSHADE_LANES {
    const bool in = keys[i] <= limit;
    bits |= uint32_t{in} << i;
    kept[i] = in ? keys[i] : 0xffff;
  }
  return bits;
}
// The first lane with the least key.
RAYSHADE_KERNEL uint32_t LaneOfLeast(const uint16_t* keys) {
  uint32_t least = 0xffff, lane = 0;
  RAYSHADE_LANES {
    lane = keys[i] < least ? static_cast<uint32_t>(i) : lane;
    least = keys[i] < least ? keys[i] : least;
  }
  return lane;
}
RAYSHADE_KERNEL float Least(F8 a) {
  float r = a.v[0];
  RAYSHADE_LANES r = a.v[i] < r ? a.v[i] : r;
  return r;
}
RAYSHADE_KERNEL float Largest(F8 a) {
  float r = a.v[0];
  RAYSHADE_LANES r = a.v[i] > r ? a.v[i] : r;
  return r;
}
RAYSHADE_KERNEL F8 Rounded(D8 a) {
  F8 r;
  RAYSHADE_LANES r.v[i] = static_cast<float>(a.v[i]);
  return r;
}
// Stores the lanes whose bits are set, one after the other; what lies behind them may change.
RAYSHADE_KERNEL void Compress(uint32_t mask, F8 a, float* to) {
  for (; mask != 0; mask &= mask - 1) *to++ = a.v[__builtin_ctz(mask)];
}
RAYSHADE_KERNEL void Compress(uint32_t mask, const uint64_t* from, uint64_t* to) {
  for (; mask != 0; mask &= mask - 1) *to++ = from[__builtin_ctz(mask)];
}
// The least and the largest of all lanes.
RAYSHADE_KERNEL double Least(D8 a) {
  double r = a.v[0];
  RAYSHADE_LANES r = a.v[i] < r ? a.v[i] : r;
  return r;
}
RAYSHADE_KERNEL double Largest(D8 a) {
  double r = a.v[0];
  RAYSHADE_LANES r = a.v[i] > r ? a.v[i] : r;
  return r;
}
#undef RAYSHADE_LANES
