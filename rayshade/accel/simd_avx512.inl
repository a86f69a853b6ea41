// Eight floats and eight doubles with AVX-512 (F, DQ, VL, BW); see simd_plain.inl. No fused
// multiply-add, so that the bits are the same.
struct F8 {
  __m256 v;
};
struct D8 {
  __m512d v;
};

RAYSHADE_KERNEL F8 LoadF(const float* p) { return {_mm256_loadu_ps(p)}; }
RAYSHADE_KERNEL F8 SetF(float x) { return {_mm256_set1_ps(x)}; }
RAYSHADE_KERNEL void Store(F8 a, float* p) { _mm256_storeu_ps(p, a.v); }
RAYSHADE_KERNEL F8 operator-(F8 a, F8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 operator*(F8 a, F8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 Min(F8 a, F8 b) { return {_mm256_min_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 Max(F8 a, F8 b) { return {_mm256_max_ps(a.v, b.v)}; }
RAYSHADE_KERNEL uint32_t LessEqual(F8 a, F8 b) { return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ); }

RAYSHADE_KERNEL F8 operator/(F8 a, F8 b) { return {_mm256_div_ps(a.v, b.v)}; }
RAYSHADE_KERNEL F8 Size(F8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
RAYSHADE_KERNEL uint32_t Less(F8 a, F8 b) { return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ); }

RAYSHADE_KERNEL D8 LoadD(const double* p) { return {_mm512_loadu_pd(p)}; }
RAYSHADE_KERNEL D8 SetD(double x) { return {_mm512_set1_pd(x)}; }
RAYSHADE_KERNEL void Store(D8 a, double* p) { _mm512_storeu_pd(p, a.v); }
RAYSHADE_KERNEL D8 operator+(D8 a, D8 b) { return {_mm512_add_pd(a.v, b.v)}; }
RAYSHADE_KERNEL D8 operator-(D8 a, D8 b) { return {_mm512_sub_pd(a.v, b.v)}; }
RAYSHADE_KERNEL D8 operator*(D8 a, D8 b) { return {_mm512_mul_pd(a.v, b.v)}; }
RAYSHADE_KERNEL D8 operator/(D8 a, D8 b) { return {_mm512_div_pd(a.v, b.v)}; }
// The plain intrinsic of g++ 12 warns about its own uninitialised source; the masked one is the
// same instruction.
RAYSHADE_KERNEL D8 Sqrt(D8 a) { return {_mm512_maskz_sqrt_pd(0xff, a.v)}; }
RAYSHADE_KERNEL uint32_t LessEqual(D8 a, D8 b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ); }
RAYSHADE_KERNEL uint32_t Less(D8 a, D8 b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ); }
RAYSHADE_KERNEL D8 Choose(uint32_t mask, D8 a, D8 b) {
  return {_mm512_mask_blend_pd(static_cast<__mmask8>(mask), b.v, a.v)};
}
RAYSHADE_KERNEL F8 operator+(F8 a, F8 b) { return {_mm256_add_ps(a.v, b.v)}; }
RAYSHADE_KERNEL D8 Min(D8 a, D8 b) { return {_mm512_maskz_min_pd(0xff, a.v, b.v)}; }
RAYSHADE_KERNEL D8 Max(D8 a, D8 b) { return {_mm512_maskz_max_pd(0xff, a.v, b.v)}; }
RAYSHADE_KERNEL __m256d LowerHalf(D8 a) { return _mm512_maskz_extractf64x4_pd(0xf, a.v, 0); }
RAYSHADE_KERNEL __m256d UpperHalf(D8 a) { return _mm512_maskz_extractf64x4_pd(0xf, a.v, 1); }
RAYSHADE_KERNEL double Least(D8 a) {
  const __m256d m = _mm256_min_pd(LowerHalf(a), UpperHalf(a));
  const __m128d n = _mm_min_pd(_mm256_castpd256_pd128(m), _mm256_extractf128_pd(m, 1));
  return _mm_cvtsd_f64(_mm_min_sd(n, _mm_unpackhi_pd(n, n)));
}
RAYSHADE_KERNEL double Largest(D8 a) {
  const __m256d m = _mm256_max_pd(LowerHalf(a), UpperHalf(a));
  const __m128d n = _mm_max_pd(_mm256_castpd256_pd128(m), _mm256_extractf128_pd(m, 1));
  return _mm_cvtsd_f64(_mm_max_sd(n, _mm_unpackhi_pd(n, n)));
}
RAYSHADE_KERNEL F8 Choose(uint32_t mask, F8 a, F8 b) {
  return {_mm256_mask_blend_ps(static_cast<__mmask8>(mask), b.v, a.v)};
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
RAYSHADE_KERNEL F8 Rounded(D8 a) { return {_mm512_maskz_cvtpd_ps(0xff, a.v)}; }
RAYSHADE_KERNEL void Compress(uint32_t mask, F8 a, float* to) {
  _mm256_storeu_ps(to, _mm256_maskz_compress_ps(static_cast<__mmask8>(mask), a.v));
}
RAYSHADE_KERNEL void Compress(uint32_t mask, const uint64_t* from, uint64_t* to) {
  const __m512i all = _mm512_loadu_si512(from);
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi64(static_cast<__mmask8>(mask), all));
}
