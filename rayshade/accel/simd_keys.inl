// Keys of eight floats, with AVX2 and with AVX-512 alike; see simd_plain.inl.

RAYSHADE_KERNEL __m128i Keys(__m256 a) {
  const __m256i keys = _mm256_srli_epi32(_mm256_castps_si256(a), 16);
  return _mm_packus_epi32(_mm256_castsi256_si128(keys), _mm256_extracti128_si256(keys, 1));
}
RAYSHADE_KERNEL void StoreKeys(F8 a, F8 b, uint16_t* keys) {
  const __m256 out = _mm256_cmp_ps(a.v, b.v, _CMP_NLE_UQ);
  _mm_store_si128(reinterpret_cast<__m128i*>(keys), Keys(_mm256_or_ps(a.v, out)));
}
RAYSHADE_KERNEL uint32_t KeepKeys(const uint16_t* keys, float most, uint16_t* kept) {
  const __m128i all = _mm_load_si128(reinterpret_cast<const __m128i*>(keys));
  const __m128i limit =
      _mm_set1_epi16(static_cast<int16_t>(__builtin_bit_cast(uint32_t, most) >> 16));
  const __m128i in = _mm_cmpeq_epi16(_mm_min_epu16(all, limit), all);
  const __m128i none = _mm_set1_epi16(-1);
  _mm_store_si128(reinterpret_cast<__m128i*>(kept), _mm_or_si128(all, _mm_xor_si128(in, none)));
  return static_cast<uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(in, _mm_setzero_si128())));
}
RAYSHADE_KERNEL uint32_t LaneOfLeast(const uint16_t* keys) {
  const __m128i all = _mm_load_si128(reinterpret_cast<const __m128i*>(keys));
  return static_cast<uint32_t>(_mm_cvtsi128_si32(_mm_minpos_epu16(all))) >> 16 & 7;
}
