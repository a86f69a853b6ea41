// The state of a trace process and its steps; private to trace_process.cc (messages),
// trace_objects.cc (objects kept and lent), trace_rays.cc (tracing and fetching), trace_shadows.cc
// (shadow rays that travel) and trace_shading.cc (spawning, gathering, shading).
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "parallel/cell_tracer.h"
#include "parallel/image_table.h"
#include "parallel/message.h"
#include "parallel/object_cache.h"
#include "parallel/pending_intersections.h"
#include "parallel/process.h"
#include "parallel/rank_index.h"
#include "parallel/ray_packer.h"
#include "parallel/ray_queue.h"
#include "parallel/shared_objects.h"
#include "parallel/trace_process.h"
#include "parallel/work_queue.h"
#include "rayshade/render/camera.h"
#include "rayshade/shade/crossing.h"
#include "rayshade/shade/hit_rows.h"
#include "rayshade/shade/shade.h"

namespace rayshade::parallel {

// In WaitingShade::arrived: the shadow ray is with another process.
inline constexpr uint8_t kUnknown = 2;

// A hit whose shadow rays wait for cells, or travel. Lights before the first undecided one are
// folded; from there on they are kept, since they are folded in order.
struct WaitingShade {
  Ray ray;
  std::vector<Medium> media;
  double distance = 0;
  ReturnAddress back;
  SurfaceHit hit;
  Color lights;  // folded so far
  std::vector<ShadowRay> shadows;
  std::vector<uint8_t> arrived;
  std::vector<std::vector<ShadowCrossing>> crossings;  // by shadow
  uint32_t unknown = 0;                                // shadow rays that are not decided
};

// The hits of a step, which are shaded together. Their rays stay in the step's queue.
struct HitBatch {
  size_t size = 0;
  std::vector<uint32_t> rays;  // their numbers
  std::vector<double> distances;
  std::vector<SurfaceHit> surfaces;
  std::vector<Color> lights;    // ambient light; at the end all that is folded
  std::vector<uint32_t> aside;  // the hit's waiting shade; kNotAside while all lights are decided

  HitBatch()
      : rays(kRaysPerStep),
        distances(kRaysPerStep),
        surfaces(kRaysPerStep),
        lights(kRaysPerStep),
        aside(kRaysPerStep) {}
};
inline constexpr uint32_t kNotAside = ~uint32_t{0};

// The shadow rays of a batch towards one light: a pyramid [RJ s.3].
struct ShadowBatch {
  std::vector<Ray> rays;
  std::vector<LightSample> samples;
  std::vector<double> limits;
  std::vector<uint32_t> hits;  // whose they are
  std::vector<uint8_t> blocked, crossed;
  std::vector<std::vector<ShadowCrossing>> crossings;
  std::vector<CellId> halted;  // the cell that they wait for; kNoCell: decided

  ShadowBatch()
      : rays(kRaysPerStep),
        samples(kRaysPerStep),
        limits(kRaysPerStep),
        hits(kRaysPerStep),
        blocked(kRaysPerStep),
        crossed(kRaysPerStep),
        crossings(kRaysPerStep),
        halted(kRaysPerStep) {}
};

// What waits for a cell that is being fetched.
struct WaitingForCell {
  RayQueue rays;                                       // to go on
  RayQueue hits;                                       // conclusive, to be located
  std::vector<std::pair<uint32_t, uint32_t>> shadows;  // waiting shade, number of its shadow ray
};

struct TraceProcess::Impl {
  Impl(const Meter* m, SharedObjects* s) : meter(m), shared(s) {}

  // trace_process.cc
  void On(ProcessId from, SetUp& message, Outbox* outbox);
  void On(ProcessId from, Distributed& message, Outbox* outbox);
  void On(ProcessId from, PrimaryRays& message, Outbox* outbox);
  void On(ProcessId from, RayTask& message, Outbox* outbox);
  void On(ProcessId from, IntersectionTask& message, Outbox* outbox);
  void On(ProcessId from, RayResults& message, Outbox* outbox);
  void Unpack(const TravellingRays& rays, RayQueue* queue) const;
  void On(ProcessId from, Stop& message, Outbox* outbox);
  template <class Message>
  void Handle(ProcessId from, std::span<const uint8_t> bytes, Outbox* outbox);
  bool Work(Outbox* outbox);
  void TakeSamples(RayQueue* rays);
  bool AskForWork(Outbox* outbox);
  void NoteBytes();

  // trace_objects.cc
  void On(ProcessId from, Objects& message, Outbox* outbox);
  void BuildOwn();
  void On(ProcessId from, CellRequest& message, Outbox* outbox);
  void On(ProcessId from, CellReply& message, Outbox* outbox);
  void TakeImage(const WireImage& image);
  void CheckAttributes(const Attributes& attributes) const;  // WireError where they name nothing
  void CheckInside(const GeomSpec& geom) const;              // of a composite
  void Install(const ObjectParcel& parcel, ObjectSet* set);
  PlacementId LocalPlacement(uint32_t number) const;

  // trace_sharing.cc
  void KeepShared(std::span<const uint8_t> objects, Outbox* outbox);
  void BuildShared();

  // trace_rays.cc
  void TraceRays(const RayQueue& rays, Outbox* outbox);
  void TraceSome(const RayQueue& rays, size_t begin, size_t count, Outbox* outbox);
  void GoOn(const RayQueue& rays, size_t i, const Hit& best, CellId cell, Outbox* outbox);
  void Miss(const Ray& ray, const ReturnAddress& back, Outbox* outbox);
  void OnHit(const RayQueue& rays, size_t i, const Hit& hit, Outbox* outbox);
  void AddToBatch(const RayQueue& rays, size_t i, const Hit& hit);
  void TakeCell(CellReply&& reply, Outbox* outbox);
  void ShadeLocated(const RayQueue& rays, Outbox* outbox);
  WaitingForCell& WaitFor(CellId cell);
  void RequestCells(Outbox* outbox);

  // trace_shadows.cc
  void On(ProcessId from, ShadowTask& message, Outbox* outbox);
  void On(ProcessId from, ShadowResults& message, Outbox* outbox);
  void SendShadow(const ReturnAddress& back, const CellTracer::Shadow& shadow, const Color& color,
                  Outbox* outbox);
  void TraceShadowTasks(Outbox* outbox);

  // trace_shading.cc
  [[gnu::always_inline]] void FetchAhead(const ReturnAddress& back) {
    if (back.process == self) pending.Fetch(back.token >> 1);
  }
  void ShadeBatch(const RayQueue& rays, Outbox* outbox);
  void Illuminate(const RayQueue& rays, size_t count, uint32_t light, Outbox* outbox);
  size_t IlluminateByRows(const RayQueue& rays, size_t count, uint32_t light);
  size_t SampleRest(const RayQueue& rays, size_t count, uint32_t light, size_t traced);
  void TraceShadows(size_t done, size_t count);
  bool Arrives(bool blocked, std::vector<ShadowCrossing>* crossings, Color* color);
  void Fold(const RayQueue& rays, size_t hit, const LightSample& sample);
  WaitingShade& Aside(const RayQueue& rays, size_t hit);
  void Wait(const RayQueue& rays, size_t shadow, Outbox* outbox);
  void ResumeShadows(const std::vector<std::pair<uint32_t, uint32_t>>& shadows, CellId cell,
                     Outbox* outbox);
  void FinishWaiting(uint32_t slot, Outbox* outbox);
  void Lit(const Ray& ray, std::span<const Medium> media, double distance, const SurfaceHit& hit,
           const Color& lights, const ReturnAddress& back, Outbox* outbox);
  void CountLaunched(RayKind kind);
  void Deliver(const ReturnAddress& back, RayKind kind, const RayResult& result, Outbox* outbox);
  void TakeResult(uint64_t token, const RayResult& result, Outbox* outbox);

  const Meter* meter;
  SharedObjects* shared;                 // null: this process keeps its objects for itself
  std::vector<uint32_t> shared_parcels;  // of `shared`, as they came
  bool stopped = false;

  // From SetUp.
  ProcessId self = 1;
  RunOptions options;
  std::shared_ptr<Scene> scene;
  std::unique_ptr<Camera> camera;
  CellTree tree;
  ObjectNumbers numbers;
  ImageTable images;
  std::vector<std::vector<bool>> images_sent;  // by process, by number
  std::shared_ptr<ObjectSet> own;
  std::unique_ptr<ObjectCache> cache;
  std::unique_ptr<CellTracer> tracer;
  std::shared_ptr<const RankIndex> ranks;  // of `own`; null where memory is short

  // Rays in work.
  std::deque<SampleRun> runs;  // of PyraClip tasks, not begun
  size_t samples = 0;          // in them
  WorkQueue queue;
  std::deque<ShadowTravel> shadow_tasks;
  RayQueue transferred;  // hits from other processes, to be located and shaded
  std::deque<CellReply> arrived_cells;
  std::map<CellId, WaitingForCell> waiting;
  std::deque<CellId> wanted_cells;  // to be requested
  size_t cells_requested = 0;
  size_t waiting_rays = 0;
  PendingIntersections pending;
  std::vector<std::unique_ptr<WaitingShade>> waiting_shades;
  std::vector<uint32_t> free_waiting_shades;
  std::unique_ptr<RayPacker> packer;
  std::optional<double> busy_before_tracing;  // seconds; of storing objects
  int requests = 0;
  int steps = 0;

  // Of the step at hand.
  RayQueue step;
  RayQueue primary_step;  // keeps its room: Pop gives and takes that of `step`
  std::vector<Sample> step_samples;
  HitBatch batch;
  ShadowBatch shadows;
  std::unique_ptr<HitRows> rows = std::make_unique<HitRows>();
  std::vector<CellTracer::Shadow> halting;
  std::vector<uint32_t> halting_numbers;
  HitPath path;
  std::vector<Hit> hits;
  std::vector<Halt> halts;

  uint64_t objects_taken = 0, objects_fetched = 0, objects_lent = 0;
  uint64_t bytes_held = 0;
  Statistics statistics;
  OpCounts& counts = statistics.counts;
};

}  // namespace rayshade::parallel
