// One object against the eight rays of a group, by the very operations of its kind's own test
// (geom/sphere.h, geom/triangle.h, geom/polygon.h); part of trace.inl. Where that test would go on
// to its slow and exact part, the ray is left to the callbacks.

// What a group of rays meets.
struct Met {
  uint32_t hit = 0;     // bits of the rays that hit
  uint32_t unsure = 0;  // bits of those left to the callbacks
  D8 distance;
};

RAYSHADE_KERNEL D8 Size(D8 a) { return Max(a, SetD(0) - a); }

RAYSHADE_KERNEL Met MeetSphere(const Bundle& b, int g, D8 x, D8 y, D8 z, D8 radius) {
  const D8 dx = LoadD(b.d[0][g]), dy = LoadD(b.d[1][g]), dz = LoadD(b.d[2][g]);
  const D8 cx = x - LoadD(b.o[0][g]), cy = y - LoadD(b.o[1][g]), cz = z - LoadD(b.o[2][g]);
  const D8 c = cx * dx + cy * dy + cz * dz;
  const D8 px = cx - c * dx, py = cy - c * dy, pz = cz - c * dz;
  const D8 discriminant = radius * radius - (px * px + py * py + pz * pz);
  Met met;
  const uint32_t real = LessEqual(SetD(0), discriminant);
  if (real == 0) return met;
  const D8 root = Sqrt(discriminant);
  const D8 first = c - root, second = c + root, least = LoadD(b.least[g]);
  met.distance = Choose(Less(least, first), first, second);
  met.hit = real & Less(least, met.distance) & LessEqual(met.distance, LoadD(b.best[g])) &
            Less(met.distance, LoadD(b.strict[g]));
  return met;
}

// Where the rays meet a plane, within their windows.
struct PlaneMet {
  uint32_t bits;
  D8 distance, cosine_size;
};
RAYSHADE_KERNEL PlaneMet MeetPlane(const Bundle& b, int g, const Vector& normal, double offset) {
  const D8 nx = SetD(normal.x), ny = SetD(normal.y), nz = SetD(normal.z);
  const D8 cosine = nx * LoadD(b.d[0][g]) + ny * LoadD(b.d[1][g]) + nz * LoadD(b.d[2][g]);
  const D8 height = nx * LoadD(b.o[0][g]) + ny * LoadD(b.o[1][g]) + nz * LoadD(b.o[2][g]);
  PlaneMet met;
  met.cosine_size = Size(cosine);
  met.distance = (SetD(offset) - height) / cosine;
  met.bits = LessEqual(SetD(kEpsilon), met.cosine_size) &
             LessEqual(LoadD(b.least[g]), met.distance) & LessEqual(met.distance, LoadD(b.best[g]));
  return met;
}

// What margins are made of: the coordinates that went into a hit.
RAYSHADE_KERNEL D8 Magnitude(const Bundle& b, int g, D8 distance, double reach) {
  const D8 far = Size(LoadD(b.o[0][g])) + Size(LoadD(b.o[1][g])) + Size(LoadD(b.o[2][g]));
  return far + Size(distance) + SetD(reach);
}

RAYSHADE_KERNEL Met MeetTriangle(const Bundle& b, int g, uint32_t asked, const TriangleShape& t) {
  const PlaneMet plane = MeetPlane(b, g, t.normal, t.offset);
  Met met;
  met.distance = plane.distance;
  if ((plane.bits & asked) == 0) return met;
  const D8 hit_u = LoadD(b.o[t.u][g]) + plane.distance * LoadD(b.d[t.u][g]);
  const D8 hit_v = LoadD(b.o[t.v][g]) + plane.distance * LoadD(b.d[t.v][g]);
  D8 weight[3];
  for (int edge = 0; edge < 3; ++edge) {
    const double* from = &t.point[edge].x;
    const D8 u = hit_u - SetD(from[t.u]), v = hit_v - SetD(from[t.v]);
    weight[edge] = SetD(t.edge_u[edge]) * v - SetD(t.edge_v[edge]) * u;
  }
  const D8 least = Min(Min(weight[0], weight[1]), weight[2]);
  const D8 margin = SetD(t.margin) * Magnitude(b, g, plane.distance, t.reach) / plane.cosine_size;
  const uint32_t in = Less(margin, least), out = Less(least, SetD(0) - margin);
  met.hit = plane.bits & in;
  met.unsure = plane.bits & ~(in | out);
  return met;
}

RAYSHADE_KERNEL Met MeetPolygon(const Bundle& b, int g, uint32_t asked, const FlatPolygon& polygon,
                                const Vector* points) {
  const PolygonPlane& p = polygon.plane;
  const PlaneMet plane = MeetPlane(b, g, p.normal, p.offset);
  Met met;
  met.distance = plane.distance;
  if ((plane.bits & asked) == 0) return met;
  const D8 hit_u = LoadD(b.o[p.u][g]) + plane.distance * LoadD(b.d[p.u][g]);
  const D8 hit_v = LoadD(b.o[p.v][g]) + plane.distance * LoadD(b.d[p.v][g]);
  const D8 margin =
      (SetD(p.margin) * Magnitude(b, g, plane.distance, p.reach) + SetD(p.off_plane)) /
      plane.cosine_size;
  const D8 wide_margin = SetD(4) * margin, zero = SetD(0), one = SetD(1);
  points += polygon.first_point;
  const double* last = &points[polygon.point_count - 1].x;
  D8 last_u = SetD(last[p.u]) - hit_u, last_v = SetD(last[p.v]) - hit_v;
  uint32_t was_above = LessEqual(zero, last_v), near = 0;
  D8 winding = zero;
  for (uint32_t i = 0; i < polygon.point_count; ++i) {
    const double* point = &points[i].x;
    const D8 u = SetD(point[p.u]) - hit_u, v = SetD(point[p.v]) - hit_v;
    near |= LessEqual(Size(v), margin);
    const uint32_t is_above = LessEqual(zero, v), crosses = was_above ^ is_above;
    if (crosses != 0) {
      const D8 cross = last_u * v - last_v * u;
      near |= crosses & LessEqual(Size(cross), wide_margin * (Size(last_u - u) + Size(last_v - v)));
      winding = winding + Choose(crosses & is_above & Less(zero, cross), one, zero) -
                Choose(crosses & was_above & Less(cross, zero), one, zero);
    }
    last_u = u;
    last_v = v;
    was_above = is_above;
  }
  const uint32_t in = Less(zero, winding) | Less(winding, zero);
  met.unsure = plane.bits & near;
  met.hit = plane.bits & in & ~near;
  return met;
}

// The objects of a leaf, one after the other.
struct LeafObject {
  LeafKind kind;
  uint32_t object;
  D8 x, y, z, radius;
  const TriangleShape* triangle;
  const FlatPolygon* polygon;
  const Vector* points;
  bool box_decides;  // every hit is checked against the object's box
};

RAYSHADE_KERNEL LeafObject ObjectOfLeaf(const TraceView& view, uint64_t branch, uint32_t i) {
  const uint32_t first = ChildOf(branch), count = CountOf(branch);
  LeafObject o;
  o.kind = KindOf(branch);
  o.object = first + i;
  o.box_decides = false;
  if (o.kind == kSphereLeaf) {
    const double* rows = view.spheres + 4 * static_cast<size_t>(first);
    o.x = SetD(rows[i]);
    o.y = SetD(rows[count + i]);
    o.z = SetD(rows[2 * count + i]);
    o.radius = SetD(rows[3 * count + i]);
  } else {
    const uint32_t index = view.flat->items[o.object - view.sphere_count].index;
    o.points = view.flat->points;
    if (o.kind == kTriangleLeaf) {
      o.triangle = &view.flat->triangles[index].shape;
    } else if (o.kind == kPolygonLeaf) {
      o.polygon = &view.flat->polygons[index];
      o.box_decides = !o.polygon->planar;
    }
  }
  return o;
}

RAYSHADE_KERNEL bool IsInParts(const LeafObject& o) {
  return o.kind == kPolygonLeaf && o.polygon->part_count != 0;
}

// asked: bits of the rays that matter; of others nothing is known where none of these meets it.
RAYSHADE_KERNEL Met MeetObject(const Bundle& b, int g, uint32_t asked, const LeafObject& o) {
  if (o.kind == kSphereLeaf) return MeetSphere(b, g, o.x, o.y, o.z, o.radius);
  if (o.kind == kTriangleLeaf) return MeetTriangle(b, g, asked, *o.triangle);
  if (o.kind == kPolygonLeaf) return MeetPolygon(b, g, asked, *o.polygon, o.points);
  Met met;
  met.distance = SetD(0);
  met.unsure = LessEqual(SetD(0), LoadD(b.best[g]));
  return met;
}
