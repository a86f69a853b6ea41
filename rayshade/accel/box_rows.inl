// Rays in rows against one box; part of trace.inl. An axis along which a ray's distances are no
// numbers does not count: Max and Min return their second argument then.

RAYSHADE_ROUTINE uint64_t MeetBox(const BoxRows& r) {
  uint64_t meets = 0;
  for (uint32_t i = 0; i < r.count; i += 8) {
    D8 entry = SetD(0), exit = LoadD(r.limit + i);
    for (int axis = 0; axis < 3; ++axis) {
      const D8 origin = LoadD(r.origin[axis] + i), inverse = LoadD(r.inverse[axis] + i);
      const D8 a = (SetD(r.low[axis]) - origin) * inverse;
      const D8 b = (SetD(r.high[axis]) - origin) * inverse;
      entry = Max(Min(a, b), entry);
      exit = Min(Max(a, b), exit);
    }
    meets |= uint64_t{LessEqual(entry, exit * SetD(kWiderBox))} << i;
  }
  return meets;
}
