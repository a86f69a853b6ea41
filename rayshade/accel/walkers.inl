// Single rays through the hierarchy, many in turn; part of trace.inl. While a ray's next node or
// leaf is on its way from memory, the others are at work. What a ray does next cannot be foreseen:
// it is put on the list of those that do the same, instead of being branched on. A list is worked
// on in short passes, in which one ray's part depends on no other's: the processor has more of them
// at work at a time than of a long one.
//
//   1. The lowest frame of a stack holds the bottom; the others hold children that were met and
//   have not been visited, at least one each.
//   2. In a sorted walk all of these are entered not beyond `most`, as far as their keys tell: the
//   upper half of a number in single precision, by which the nearest is found as well.

constexpr uint32_t kWalkers = 36;
constexpr int kAtBottom = kOtherLeaf + 1;
constexpr uint64_t kBottomBranch[] = {uint64_t{kAtBottom} << kKindShift};
constexpr float kBottomEntry[] = {0, 1, 1, 1, 1, 1, 1, 1};  // its first lane waits

// Children of a node that wait.
struct alignas(32) Frame {
  uint16_t keys[kNodeWidth];  // of where they are entered, in a sorted walk (simd_plain.inl)
  const uint64_t* branch;     // of the node
  uint32_t waiting;           // bits
};

// What a bundle that gave up had not visited: children of nodes, the nearest first, eight a row.
constexpr uint32_t kUnvisitedRows = 8;
struct Unvisited {
  uint64_t branch[kUnvisitedRows][kNodeWidth];
  alignas(32) float entry[kUnvisitedRows][kNodeWidth];
};

// A ray of an array that is traced by itself.
struct LoneRay {
  uint32_t index;
  double limit;           // that of hits of strict kinds, or of all
  const Unvisited* rest;  // null: it has everything before it
  uint64_t met;           // bits, of what of the rest it meets
};

constexpr uint32_t kLoneMost = 512;
constexpr uint32_t kRestsMost = 16;
struct LoneRays {
  LoneRay rays[kLoneMost];
  uint32_t count = 0;
  Unvisited rests[kRestsMost];
  uint32_t rest_count = 0;

  void Append(uint32_t index, double limit, const Unvisited* rest = nullptr, uint64_t met = 0) {
    rays[count++] = {index, limit, rest, met};
  }
  void Clear() { count = rest_count = 0; }
};

// One ray in work.
struct Walker {
  SlabRay slab;
  float most;     // distance beyond which nothing matters, loosened
  uint32_t top;   // frames
  uint64_t next;  // what is to be visited now
  uint32_t index;
  RayWork work;
  Hit hit;
  Ray own;  // where it is not the caller's
  // More than there can be: what all walkers use most should not share a few sets of the cache.
  Frame frames[kDepthMax + 13 + kUnvisitedRows];
};
static_assert(sizeof(Walker) % 512 == 4 * 64);

// Takes what is visited next off a frame, of a sorted walk the nearest, and the frame off the stack
// if it was the last.
RAYSHADE_KERNEL void Take(bool sorted, uint32_t frame, Walker* w) {
  Frame& f = w->frames[frame];
  const uint32_t lane =
      sorted ? LaneOfLeast(f.keys) : static_cast<uint32_t>(__builtin_ctz(f.waiting));
  w->next = f.branch[lane];
  const uint32_t waiting = f.waiting & ~(1u << lane);
  f.waiting = waiting;
  if (sorted) f.keys[lane] = 0xffff;
  w->top = frame + (waiting != 0);
}

// limit: the distance beyond which nothing matters.
RAYSHADE_KERNEL void PutAtBeginning(bool sorted, const LoneRay& lone, double limit, Walker* w) {
  w->most = Loosened(limit);
  w->frames[0].branch = kBottomBranch;
  w->frames[0].waiting = 1;
  if (sorted) StoreKeys(LoadF(kBottomEntry), SetF(0), w->frames[0].keys);
  w->top = 1;
  w->next = MakeBranch(kInnerNode, 0, 0);
  if (lone.rest == nullptr) return;
  for (uint32_t row = kUnvisitedRows; row-- > 0;) {
    Frame& f = w->frames[w->top];
    f.waiting = static_cast<uint32_t>(lone.met >> 8 * row) & 0xff;
    f.branch = lone.rest->branch[row];
    if (sorted) {
      const F8 infinite = SetF(__builtin_inff());
      const F8 end = Choose(f.waiting, infinite, SetF(0) - infinite);
      StoreKeys(LoadF(lone.rest->entry[row]), end, f.keys);
    }
    w->top += f.waiting != 0;
  }
  Take(sorted, w->top - 1, w);
}

// What a walker meets where it is: bits of children, or of objects to be tested.
struct Encounter {
  Walker* walker;
  uint32_t met;
};

// Looks into a node.
RAYSHADE_KERNEL Encounter LookIntoNode(const TraceView& view, bool sorted, Walker* w) {
  const Node& node = view.nodes[ChildOf(w->next)];
  F8 entry, end;
  MeetChildren(node, w->slab, w->most, &entry, &end);
  if (sorted) StoreKeys(entry, end, w->frames[w->top].keys);
  return {w, LessEqual(entry, end)};
}

// Next is a child that was met, or if none was, what waits on the stack.
RAYSHADE_KERNEL void Descend(const TraceView& view, bool sorted, const Encounter& e) {
  Walker* const w = e.walker;
  const uint32_t top = w->top;
  w->frames[top].branch = view.nodes[ChildOf(w->next)].branch;
  w->frames[top].waiting = e.met;
  Take(sorted, top - (e.met == 0), w);
}

// Takes what is entered beyond `most` off the stack.
RAYSHADE_KERNEL void Prune(Walker* w) {
  uint32_t kept = 1;
  for (uint32_t i = 1; i < w->top; ++i) {
    const Frame& f = w->frames[i];
    Frame& to = w->frames[kept];
    const uint32_t waiting = f.waiting & KeepKeys(f.keys, w->most, to.keys);
    to.branch = f.branch;
    to.waiting = waiting;
    kept += waiting != 0;
  }
  w->top = kept;
}

// Walkers by the kind of what they visit next, and where that lies.
constexpr int kKinds = kAtBottom + 1;
struct Lists {
  Walker* of[kKinds][kWalkers];
  Walker** end[kKinds];
  const char* base[kKinds];
  uint32_t shift[kKinds] = {};  // of a number, for bytes

  uint32_t count(int kind) const { return static_cast<uint32_t>(end[kind] - of[kind]); }
  void Clear(int kind) { end[kind] = of[kind]; }
};

RAYSHADE_KERNEL void SetUp(const TraceView& view, Lists* lists) {
  for (int kind = 0; kind < kKinds; ++kind) lists->Clear(kind);
  for (const char*& base : lists->base) base = reinterpret_cast<const char*>(view.nodes);
  lists->shift[kInnerNode] = 8;
  if (view.sphere_count > 0) {
    lists->base[kSphereLeaf] = reinterpret_cast<const char*>(view.spheres);
    lists->shift[kSphereLeaf] = 5;
  }
}

RAYSHADE_KERNEL void Enlist(Walker* w, Lists* lists) {
  const LeafKind kind = KindOf(w->next);
  *lists->end[kind]++ = w;
  const char* const place =
      lists->base[kind] + (static_cast<size_t>(ChildOf(w->next)) << lists->shift[kind]);
  // As much as a node, and mostly more than a leaf: to ask for less takes longer.
  static_assert(sizeof(Node) == 256 && 4 * sizeof(double) == 32);
  for (size_t at = 0; at < sizeof(Node); at += 64) __builtin_prefetch(place + at);
}

RAYSHADE_KERNEL void VisitNodes(const TraceView& view, bool sorted, Lists* lists,
                                Counters* counters) {
  // The list is written again while this is worked on.
  Encounter at[kWalkers];
  const uint32_t count = lists->count(kInnerNode);
  lists->Clear(kInnerNode);
  counters->nodes += count;
  counters->lone_nodes += count;
  for (uint32_t i = 0; i < count; ++i) {
    at[i] = LookIntoNode(view, sorted, lists->of[kInnerNode][i]);
  }
  for (uint32_t i = 0; i < count; ++i) Descend(view, sorted, at[i]);
  for (uint32_t i = 0; i < count; ++i) Enlist(at[i].walker, lists);
}

template <class Job>
RAYSHADE_KERNEL void VisitLeaves(const TraceView& view, const Job& job, LeafKind kind, Lists* lists,
                                 Counters* counters) {
  Walker* at[kWalkers];
  Encounter tested[kWalkers];
  const uint32_t count = lists->count(kind);
  lists->Clear(kind);
  uint32_t tests = 0, objects = 0;
  for (uint32_t i = 0; i < count; ++i) {
    Walker* const w = at[i] = lists->of[kind][i];
    if (kind == kOtherLeaf) CountTests(view, kind, w->next, 1, counters);
    objects += CountOf(w->next);
    const uint32_t bits = LookIntoLeaf(view, kind, w->next, w->work, w->most);
    tested[tests] = {w, bits};
    tests += bits != 0;
    __builtin_prefetch(view.keys + (bits != 0 ? ChildOf(w->next) : 0));
  }
  counters->lone_tests += objects;
  if (kind != kOtherLeaf) counters->flat_tests[kind] += objects;
  for (uint32_t i = 0; i < tests; ++i) AtLeaf(job, kind, tested[i].met, tested[i].walker);
  for (uint32_t i = 0; i < count; ++i) {
    Take(Job::kSorted, at[i]->top - 1, at[i]);
    Enlist(at[i], lists);
  }
}

// Start(job, k, walker) prepares the ray number k, and is false where there is nothing to walk for;
// AtLeaf(job, kind, bits, walker) tests objects of a leaf, and empties the stack where the ray is
// done; End(job, walker) takes the result.
template <class Job>
RAYSHADE_KERNEL void Walk(const TraceView& view, const Job& job, uint32_t count,
                          Counters* counters) {
  Walker walkers[kWalkers];
  Lists lists;
  SetUp(view, &lists);
  const uint32_t used = count < kWalkers ? count : kWalkers;
  for (uint32_t i = 0; i < used; ++i) lists.of[kAtBottom][i] = walkers + i;
  uint32_t ended = used, begun = 0, at_work = used;
  for (;;) {
    // New rays in place of those that ended.
    at_work -= ended;
    for (uint32_t i = 0; i < ended; ++i) {
      Walker* const w = lists.of[kAtBottom][i];
      while (begun < count) {
        if (!Start(job, begun++, w)) continue;
        Enlist(w, &lists);
        ++at_work;
        break;
      }
    }
    if (at_work == 0) return;
    VisitNodes(view, Job::kSorted, &lists, counters);
    VisitLeaves(view, job, kSphereLeaf, &lists, counters);
    for (const LeafKind kind : {kEmptySlot, kTriangleLeaf, kPolygonLeaf, kOtherLeaf}) {
      if (lists.count(kind) != 0) VisitLeaves(view, job, kind, &lists, counters);
    }
    ended = lists.count(kAtBottom);
    lists.Clear(kAtBottom);
    for (uint32_t i = 0; i < ended; ++i) End(job, lists.of[kAtBottom][i]);
  }
}

// Improves the rays' hits.
struct NearestJob {
  static constexpr bool kSorted = true;
  const TraceView& view;
  const Ray* rays;
  Hit* hits;
  const LoneRay* lone;
  Counters* counters;
};

RAYSHADE_KERNEL void End(const NearestJob& job, Walker* w) {
  Hit& hit = job.hits[w->index];
  if (w->hit.rank == hit.rank) return;
  hit = w->hit;
  hit.set = job.view.owner;
}
RAYSHADE_KERNEL bool Start(const NearestJob& job, uint32_t k, Walker* w) {
  const TraceView& view = job.view;
  const LoneRay& lone = job.lone[k];
  const Ray& ray = job.rays[lone.index];
  w->index = lone.index;
  w->hit = job.hits[w->index];
  SetUp(view, ray, &w->work, &w->slab);
  w->work.strict_limit = lone.limit;
  for (uint32_t i = 0; lone.rest == nullptr && i < view.unbounded_count; ++i) {
    view.callbacks.nearest_other(view.set, ray, view.unbounded[i], lone.limit, &w->hit);
    CountTest(view, view.unbounded[i], 1, job.counters);
  }
  PutAtBeginning(true, lone, w->hit.distance, w);
  if (view.node_count == 0) End(job, w);
  return view.node_count > 0;
}
RAYSHADE_KERNEL void AtLeaf(const NearestJob& job, LeafKind kind, uint32_t bits, Walker* w) {
  const double before = w->hit.distance;
  NearestInLeaf(job.view, kind, w->work, w->next, bits, &w->hit);
  if (w->hit.distance == before) return;
  w->most = Loosened(w->hit.distance);
  Prune(w);
}

RAYSHADE_ROUTINE void NearestOfLone(const TraceView& view, const Ray* rays, Hit* hits,
                                    const LoneRay* lone, uint32_t count, Counters* counters) {
  Walk(view, NearestJob{view, rays, hits, lone, counters}, count, counters);
}

// What becomes of shadow rays; see ObjectSet::Block. crossed may be null.
struct Fate {
  uint8_t *blocked, *crossed;
};

// Shadow rays. LoadLone(source, index, walker) returns the ray, which may be the walker's own.
template <class Source>
struct BlockJob {
  static constexpr bool kSorted = false;
  const TraceView& view;
  const Source& source;
  const LoneRay* lone;
  Fate fate;
  Counters* counters;
};

template <class Source>
RAYSHADE_KERNEL bool Start(const BlockJob<Source>& job, uint32_t k, Walker* w) {
  const TraceView& view = job.view;
  const LoneRay& lone = job.lone[k];
  const Ray& ray = LoadLone(job.source, lone.index, w);
  w->index = lone.index;
  uint8_t crossed = 0;
  for (uint32_t i = 0; lone.rest == nullptr && i < view.unbounded_count; ++i) {
    CountTest(view, view.unbounded[i], 1, job.counters);
    if (!OtherBlocks(view, ray, view.unbounded[i], lone.limit, &crossed)) continue;
    CountHit(view, view.unbounded[i], job.counters);
    job.fate.blocked[lone.index] = 1;
    return false;
  }
  if (crossed && job.fate.crossed != nullptr) job.fate.crossed[lone.index] = 1;
  SetUp(view, ray, &w->work, &w->slab);
  w->work.strict_limit = lone.limit;
  PutAtBeginning(false, lone, lone.limit, w);
  return view.node_count > 0;
}
template <class Source>
RAYSHADE_KERNEL void AtLeaf(const BlockJob<Source>& job, LeafKind kind, uint32_t bits, Walker* w) {
  uint8_t crossed = 0;
  const bool blocks = LeafBlocks(job.view, kind, w->work, w->next, bits, w->work.strict_limit,
                                 &crossed, job.counters);
  if (crossed && job.fate.crossed != nullptr) job.fate.crossed[w->index] = 1;
  if (!blocks) return;
  job.fate.blocked[w->index] = 1;
  w->top = 1;  // the bottom
}
template <class Source>
RAYSHADE_KERNEL void End(const BlockJob<Source>&, Walker*) {}

RAYSHADE_KERNEL const Ray& LoadLone(const Ray* rays, uint32_t index, Walker*) {
  return rays[index];
}
RAYSHADE_ROUTINE void BlockLone(const TraceView& view, const Ray* rays, const LoneRay* lone,
                                uint32_t count, const Fate& fate, Counters* counters) {
  Walk(view, BlockJob<const Ray*>{view, rays, lone, fate, counters}, count, counters);
}
