// What a light does to rows of hits before and after its shadow rays are traced; part of trace.inl.

// Eight bytes of 0 or 1 from eight bits, and back.
RAYSHADE_KERNEL uint64_t BytesOf(uint32_t bits) {
  const uint64_t spread = bits * 0x0101010101010101u & 0x8040201008040201u;
  return (spread + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
}
RAYSHADE_KERNEL uint32_t BitsOf(uint64_t bytes) {
  return static_cast<uint32_t>(bytes * 0x0102040810204080u >> 56);
}
// Of the first `count` bytes, at most eight.
RAYSHADE_KERNEL uint32_t BitsAt(const uint8_t* bytes, uint32_t count) {
  uint64_t all = 0;
  __builtin_memcpy(&all, bytes, count < 8 ? count : 8);
  return BitsOf(all);
}

RAYSHADE_ROUTINE void Sort(const SortRows& r) {
  for (uint32_t i = 0; i < r.count; i += 8) {
    const D8 cosine = LoadD(r.toward[0] + i) * LoadD(r.face[0] + i) +
                      LoadD(r.toward[1] + i) * LoadD(r.face[1] + i) +
                      LoadD(r.toward[2] + i) * LoadD(r.face[2] + i);
    const uint32_t by_row =
        LessEqual(LoadD(r.slack + i), SetD(kShadowEpsilon) * Max(cosine, SetD(0) - cosine));
    const uint32_t dark = ~(by_row & Less(SetD(0), LoadD(r.cosine + i))) & 0xff;
    const uint64_t rows = BytesOf(by_row), darkness = BytesOf(dark);
    __builtin_memcpy(r.by_row + i, &rows, 8);
    __builtin_memcpy(r.dark + i, &darkness, 8);
  }
}

// The very operations of AddLight (shade/lights.cc).
RAYSHADE_ROUTINE void AddDiffuse(const DiffuseRows& r) {
  for (uint32_t i = 0; i < r.count; i += 8) {
    const uint32_t lit = ~BitsAt(r.dark + i, r.count - i) & 0xff;
    if (lit == 0) continue;
    const D8 cosine = LoadD(r.cosine + i);
    for (int c = 0; c < 3; ++c) {
      const D8 sum = LoadD(r.sum[c] + i);
      const D8 more = sum + cosine * LoadD(r.diffuse[c] + i) * SetD(r.arrived[c]);
      Store(lit == 0xff ? more : Choose(lit, more, sum), r.sum[c] + i);
    }
  }
}

RAYSHADE_ROUTINE void Shine(const ShineRows& r) {
  for (uint32_t i = 0; i < r.count; i += 8) {
    uint32_t shines = ~BitsAt(r.dark + i, r.count - i) & 0xff;
    if (shines != 0) {
      const D8 cosine = LoadD(r.mirror[0] + i) * LoadD(r.toward[0] + i) +
                        LoadD(r.mirror[1] + i) * LoadD(r.toward[1] + i) +
                        LoadD(r.mirror[2] + i) * LoadD(r.toward[2] + i);
      const D8 sum = Min(Min(LoadD(r.sum[0] + i), LoadD(r.sum[1] + i)), LoadD(r.sum[2] + i));
      const uint32_t faint = Less(cosine, LoadD(r.least + i)) &
                             Less(LoadD(r.specular + i) * SetD(r.arrived), SetD(kFaint) * sum);
      shines &= ~faint;
    }
    const uint64_t bytes = BytesOf(shines);
    __builtin_memcpy(r.shines + i, &bytes, 8);
  }
}
