// The state of a trace process and its steps; private to trace_process.cc (messages), trace_rays.cc
// (tracing and fetching), trace_shadows.cc (shadow rays that travel) and trace_shading.cc
// (spawning, gathering, shading).
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "parallel/cell_tracer.h"
#include "parallel/image_table.h"
#include "parallel/message.h"
#include "parallel/object_cache.h"
#include "parallel/pending_intersections.h"
#include "parallel/process.h"
#include "parallel/ray_packer.h"
#include "parallel/ray_queue.h"
#include "parallel/trace_process.h"
#include "parallel/work_queue.h"
#include "rayshade/render/camera.h"
#include "rayshade/shade/crossing.h"
#include "rayshade/shade/shade.h"

namespace rayshade::parallel {

// In WaitingShade::arrived: the shadow ray is with another process.
inline constexpr uint8_t kUnknown = 2;

// A hit whose shadow rays wait for cells, or travel.
struct WaitingShade {
  Ray ray;
  std::vector<Medium> media;
  double distance = 0;
  ReturnAddress back;
  SurfaceHit hit;
  std::vector<ShadowRay> shadows;
  std::vector<uint8_t> arrived;
  std::vector<std::vector<ShadowCrossing>>
      crossings;         // by shadow; empty where nothing is transparent
  uint32_t unknown = 0;  // shadow rays that are not decided
};

// A member of a definition, which several placed objects share.
struct Member {
  GeomSpec spec;
  std::shared_ptr<const Geom> geom;
};

// What waits for a cell that is being fetched.
struct WaitingForCell {
  RayQueue rays;                                       // to go on
  RayQueue hits;                                       // conclusive, to be located
  std::vector<std::pair<uint32_t, uint32_t>> shadows;  // waiting shade, number of its shadow ray
};

struct TraceProcess::Impl {
  explicit Impl(const Meter* m) : meter(m) {}

  // trace_process.cc
  void On(ProcessId from, SetUp& message, Outbox* outbox);
  void On(ProcessId from, Objects& message, Outbox* outbox);
  void On(ProcessId from, Distributed& message, Outbox* outbox);
  void On(ProcessId from, PrimaryRays& message, Outbox* outbox);
  void On(ProcessId from, RayTask& message, Outbox* outbox);
  void On(ProcessId from, IntersectionTask& message, Outbox* outbox);
  void On(ProcessId from, RayResults& message, Outbox* outbox);
  void Unpack(const TravellingRays& rays, RayQueue* queue) const;
  void On(ProcessId from, CellRequest& message, Outbox* outbox);
  void On(ProcessId from, CellReply& message, Outbox* outbox);
  void On(ProcessId from, Stop& message, Outbox* outbox);
  template <class Message>
  void Handle(ProcessId from, std::span<const uint8_t> bytes, Outbox* outbox);
  void TakeImage(const WireImage& image);
  void CheckAttributes(const Attributes& attributes) const;  // WireError where they name nothing
  void CheckInside(const GeomSpec& geom) const;              // of a composite
  void Install(const ObjectParcel& parcel, ObjectSet* set);
  PlacementId LocalPlacement(uint32_t number) const;
  bool Work(Outbox* outbox);
  void TakeSamples(RayQueue* rays);
  bool AskForWork(Outbox* outbox);
  void NoteBytes();

  // trace_rays.cc
  void TraceStep(const RayQueue& rays, Outbox* outbox);
  void Miss(const Ray& ray, const ReturnAddress& back, Outbox* outbox);
  void OnHit(const RayQueue& rays, size_t i, const Hit& hit, Outbox* outbox);
  void TakeCell(CellReply&& reply, Outbox* outbox);
  void LocateHits(const RayQueue& rays);
  WaitingForCell& WaitFor(CellId cell);
  void RequestCells(Outbox* outbox);

  // trace_shadows.cc
  void On(ProcessId from, ShadowTask& message, Outbox* outbox);
  void On(ProcessId from, ShadowResults& message, Outbox* outbox);
  void SendShadow(const ReturnAddress& back, const CellTracer::Shadow& shadow, Outbox* outbox);
  void TraceShadowTasks(Outbox* outbox);

  // trace_shading.cc
  bool Arrives(CellTracer::Shadow* shadow);
  void ShadeHits(Outbox* outbox);
  void TraceShadows(std::vector<uint32_t>* first);
  void PutAside(size_t i, std::span<const uint32_t> first, Outbox* outbox);
  void ResumeShadows(const std::vector<std::pair<uint32_t, uint32_t>>& shadows, CellId cell,
                     Outbox* outbox);
  void FinishWaiting(uint32_t slot, Outbox* outbox);
  void Lit(const Ray& ray, std::span<const Medium> media, double distance, const SurfaceHit& hit,
           std::span<const ShadowRay> shadows, std::span<const uint8_t> arrived,
           const ReturnAddress& back, Outbox* outbox);
  void Launch(const RayBundle& one, const ReturnAddress& back);
  void Deliver(const ReturnAddress& back, RayKind kind, const RayResult& result, Outbox* outbox);
  void TakeResult(uint64_t token, const RayResult& result, Outbox* outbox);

  const Meter* meter;
  bool stopped = false;

  // From SetUp.
  ProcessId self = 1;
  RunOptions options;
  std::unique_ptr<Scene> scene;
  std::unique_ptr<Camera> camera;
  CellTree tree;
  std::map<uint32_t, PlacementId> placements;      // by number in the run
  std::vector<uint32_t> placement_numbers;         // in the run, by PlacementId
  std::map<uint32_t, Member> members;              // by number in the run
  std::map<const Geom*, uint32_t> member_numbers;  // looked up only, never walked
  ImageTable images;
  std::vector<std::vector<bool>> images_sent;  // by process, by number
  std::unique_ptr<ObjectSet> own;
  std::unique_ptr<ObjectCache> cache;
  std::unique_ptr<CellTracer> tracer;

  // Rays in work.
  std::deque<Sample> samples;  // of PyraClip tasks, not begun
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
  int requests = 0;
  int steps = 0;

  // The batch of hits being shaded, with resolved[i] for rays i.
  RayQueue batch;
  std::vector<SurfaceHit> resolved;
  std::vector<double> distances;
  std::vector<ShadowRay> shadows;
  std::vector<uint8_t> arrived;
  std::vector<std::vector<ShadowCrossing>> crossings;
  std::vector<CellId> halted;  // by shadow; kNoCell: decided

  // Scratch of a step.
  RayQueue step;
  std::vector<uint32_t> first_shadow;
  std::vector<uint32_t> next_shadow;
  std::vector<CellTracer::Shadow> light_shadows;
  std::vector<uint32_t> of_light;
  RayBundle transmitted, reflected;
  HitPath path;
  std::vector<Hit> hits;
  std::vector<Halt> halts;

  uint64_t objects_taken = 0;
  uint64_t bytes_held = 0;
  Statistics statistics;
  OpCounts& counts = statistics.counts;
};

}  // namespace rayshade::parallel
