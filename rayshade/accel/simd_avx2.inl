// Eight floats and eight doubles with AVX2; see simd_plain.inl. No fused multiply-add, so that the
// bits are the same.
struct F8 {
  __m256 v;
};
struct D8 {
  __m256d a, b;
};

RAYSHADE_KERNEL F8 LoadF(const float* p) { return {_mm256_loadu_ps(p)}; }
RAYSHADE_KERNEL F8 SetF(float x) { return {_mm256_set1_ps(x)}; }
RAYSHADE_KERNEL void Store(F8 a, float* p) { _mm256_storeu_ps(p, a.v); }
RAYSHADE_KERNEL F8 operator-(F8 a, F8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 operator*(F8 a, F8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 Min(F8 a, F8 b) { return {_mm256_min_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 Max(F8 a, F8 b) { return {_mm256_max_ps(a.v, b.v)}; }
RAYSHADE_KERNEL uint32_t LessEqual(F8 a, F8 b) {
  return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}

RAYSHADE_KERNEL F8 operator/(F8 a, F8 b) { return {_mm256_div_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 Size(F8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
RAYSHADE_KERNEL uint32_t Less(F8 a, F8 b) {
  return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)));
}

RAYSHADE_KERNEL D8 LoadD(const double* p) { return {_mm256_loadu_pd(p), _mm256_loadu_pd(p + 4)}; }
RAYSHADE_KERNEL D8 SetD(double x) { return {_mm256_set1_pd(x), _mm256_set1_pd(x)}; }
RAYSHADE_KERNEL void Store(D8 a, double* p) {
  _mm256_storeu_pd(p, a.a);
  _mm256_storeu_pd(p + 4, a.b);
}
RAYSHADE_KERNEL D8 operator+(D8 a, D8 b) {
  return {_mm256_add_pd(a.a, b.a), _mm256_add_pd(a.b, b.b)};
}
RAYSHADE_KERNEL D8 operator-(D8 a, D8 b) {
  return {_mm256_sub_pd(a.a, b.a), _mm256_sub_pd(a.b, b.b)};
}
RAYSHADE_KERNEL D8 operator*(D8 a, D8 b) {
  return {_mm256_mul_pd(a.a, b.a), _mm256_mul_pd(a.b, b.b)};
}
RAYSHADE_KERNEL D8 operator/(D8 a, D8 b) {
  return {_mm256_div_pd(a.a, b.a), _mm256_div_pd(a.b, b.b)};
}
RAYSHADE_KERNEL D8 Sqrt(D8 a) { return {_mm256_sqrt_pd(a.a), _mm256_sqrt_pd(a.b)}; }
RAYSHADE_KERNEL uint32_t Bits(__m256d a, __m256d b) {
  return static_cast<uint32_t>(_mm256_movemask_pd(a) | _mm256_movemask_pd(b) << 4);
}
RAYSHADE_KERNEL uint32_t LessEqual(D8 a, D8 b) {
  return Bits(_mm256_cmp_pd(a.a, b.a, _CMP_LE_OQ), _mm256_cmp_pd(a.b, b.b, _CMP_LE_OQ));
}
RAYSHADE_KERNEL uint32_t Less(D8 a, D8 b) {
  return Bits(_mm256_cmp_pd(a.a, b.a, _CMP_LT_OQ), _mm256_cmp_pd(a.b, b.b, _CMP_LT_OQ));
}
RAYSHADE_KERNEL __m256d Lanes(uint32_t mask) {
  const __m256i bit = _mm256_setr_epi64x(1, 2, 4, 8);
  const __m256i set = _mm256_and_si256(_mm256_set1_epi64x(mask), bit);
  return _mm256_castsi256_pd(_mm256_cmpeq_epi64(set, bit));
}
RAYSHADE_KERNEL D8 Choose(uint32_t mask, D8 a, D8 b) {
  return {_mm256_blendv_pd(b.a, a.a, Lanes(mask)), _mm256_blendv_pd(b.b, a.b, Lanes(mask >> 4))};
}
RAYSHADE_KERNEL F8 operator+(F8 a, F8 b) { return {_mm256_add_ps(a.v, b.v)}; }
RAYSHADE_KERNEL D8 Min(D8 a, D8 b) { return {_mm256_min_pd(a.a, b.a), _mm256_min_pd(a.b, b.b)}; }
RAYSHADE_KERNEL D8 Max(D8 a, D8 b) { return {_mm256_max_pd(a.a, b.a), _mm256_max_pd(a.b, b.b)}; }
RAYSHADE_KERNEL double Least(D8 a) {
  const __m256d m = _mm256_min_pd(a.a, a.b);
  const __m128d n = _mm_min_pd(_mm256_castpd256_pd128(m), _mm256_extractf128_pd(m, 1));
  return _mm_cvtsd_f64(_mm_min_sd(n, _mm_unpackhi_pd(n, n)));
}
RAYSHADE_KERNEL double Largest(D8 a) {
  const __m256d m = _mm256_max_pd(a.a, a.b);
  const __m128d n = _mm_max_pd(_mm256_castpd256_pd128(m), _mm256_extractf128_pd(m, 1));
  return _mm_cvtsd_f64(_mm_max_sd(n, _mm_unpackhi_pd(n, n)));
}
RAYSHADE_KERNEL F8 Choose(uint32_t mask, F8 a, F8 b) {
  const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  const __m256i set = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(mask)), bit);
  return {_mm256_blendv_ps(b.v, a.v, _mm256_castsi256_ps(_mm256_cmpeq_epi32(set, bit)))};
}
RAYSHADE_KERNEL float Least(F8 a) {
  __m128 m = _mm_min_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
  m = _mm_min_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_movehdup_ps(m)));
}
RAYSHADE_KERNEL float Largest(F8 a) {
  __m128 m = _mm_max_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
  m = _mm_max_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_max_ss(m, _mm_movehdup_ps(m)));
}
RAYSHADE_KERNEL F8 Rounded(D8 a) {
  return {_mm256_set_m128(_mm256_cvtpd_ps(a.b), _mm256_cvtpd_ps(a.a))};
}
// Lanes of four whose bits are set, one after the other.
struct CompressTable {
  alignas(32) uint32_t of_four[16][4], of_pairs[16][8];

  constexpr CompressTable() : of_four(), of_pairs() {
    for (uint32_t mask = 0; mask < 16; ++mask) {
      uint32_t count = 0;
      for (uint32_t lane = 0; lane < 4; ++lane) {
        if ((mask >> lane & 1) == 0) continue;
        of_four[mask][count] = lane;
        of_pairs[mask][2 * count] = 2 * lane;
        of_pairs[mask][2 * count + 1] = 2 * lane + 1;
        ++count;
      }
    }
  }
};
constexpr CompressTable kCompress;

RAYSHADE_KERNEL void Compress(uint32_t mask, F8 a, float* to) {
  const uint32_t low = mask & 15, high = mask >> 4;
  const auto lanes = [](uint32_t m) {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(kCompress.of_four[m]));
  };
  const __m128 b = _mm256_extractf128_ps(a.v, 1);
  _mm_storeu_ps(to, _mm_permutevar_ps(_mm256_castps256_ps128(a.v), lanes(low)));
  _mm_storeu_ps(to + __builtin_popcount(low), _mm_permutevar_ps(b, lanes(high)));
}
RAYSHADE_KERNEL void Compress(uint32_t mask, const uint64_t* from, uint64_t* to) {
  const uint32_t low = mask & 15, high = mask >> 4;
  const auto lanes = [](uint32_t m) {
    return _mm256_load_si256(reinterpret_cast<const __m256i*>(kCompress.of_pairs[m]));
  };
  const auto four = [](const uint64_t* p) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
  };
  const auto store = [](uint64_t* p, __m256i v) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), v);
  };
  const __m256i a = four(from), b = four(from + 4);
  store(to, _mm256_permutevar8x32_epi32(a, lanes(low)));
  store(to + __builtin_popcount(low), _mm256_permutevar8x32_epi32(b, lanes(high)));
}
