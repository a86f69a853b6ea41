// Messages and steps of a trace process; see trace_process.h.
#include "parallel/trace_process.h"

#include <algorithm>

#include "parallel/math_probe.h"
#include "parallel/trace_impl.h"
#include "rayshade/common/check.h"

namespace rayshade::parallel {

TraceProcess::TraceProcess(const Meter* meter, SharedObjects* shared)
    : impl_(std::make_unique<Impl>(meter, shared)) {}
TraceProcess::~TraceProcess() = default;

bool TraceProcess::finished() const { return impl_->stopped; }

WorkDone TraceProcess::work_done() const {
  const Impl& p = *impl_;
  return {p.counts, p.objects_taken, p.objects_fetched, p.objects_lent,
          p.statistics.data_rays + p.statistics.forwarded_rays};
}

uint64_t TraceProcess::bytes_held() const { return impl_->bytes_held; }

size_t TraceProcess::rays_in_work() const {
  const Impl& p = *impl_;
  return p.samples + p.queue.size() + p.transferred.size() + p.waiting_rays +
         p.waiting_shades.size() - p.free_waiting_shades.size() + (p.packer ? p.packer->size() : 0);
}

bool TraceProcess::Work(Outbox* outbox) { return impl_->Work(outbox); }

template <class Message>
void TraceProcess::Impl::Handle(ProcessId from, std::span<const uint8_t> bytes, Outbox* outbox) {
  Message message = Decode<Message>(bytes);
  On(from, message, outbox);
}

void TraceProcess::Receive(ProcessId from, std::span<const uint8_t> bytes, Outbox* outbox) {
  const Tag tag = TagOf(bytes);
  Impl& p = *impl_;
  if (tag != Tag::kSetUp && tag != Tag::kStop && p.scene == nullptr) {
    throw WireError(std::string(NameOf(tag)) + " before SetUp");
  }
  switch (tag) {
    case Tag::kSetUp:
      return p.Handle<SetUp>(from, bytes, outbox);
    case Tag::kObjects:
      if (p.shared != nullptr) return p.KeepShared(bytes, outbox);
      return p.Handle<Objects>(from, bytes, outbox);
    case Tag::kDistributed:
      return p.Handle<Distributed>(from, bytes, outbox);
    case Tag::kStop:
      return p.Handle<Stop>(from, bytes, outbox);
    default:
      break;
  }
  if (p.tracer == nullptr) throw WireError(std::string(NameOf(tag)) + " before Distributed");
  switch (tag) {
    case Tag::kPrimaryRays:
      return p.Handle<PrimaryRays>(from, bytes, outbox);
    case Tag::kRayTask:
      return p.Handle<RayTask>(from, bytes, outbox);
    case Tag::kIntersectionTask:
      return p.Handle<IntersectionTask>(from, bytes, outbox);
    case Tag::kRayResults:
      return p.Handle<RayResults>(from, bytes, outbox);
    case Tag::kCellRequest:
      return p.Handle<CellRequest>(from, bytes, outbox);
    case Tag::kCellReply:
      return p.Handle<CellReply>(from, bytes, outbox);
    case Tag::kShadowTask:
      return p.Handle<ShadowTask>(from, bytes, outbox);
    case Tag::kShadowResults:
      return p.Handle<ShadowResults>(from, bytes, outbox);
    default:
      throw WireError(std::string(NameOf(tag)) + " is not for a trace process");
  }
}

void TraceProcess::Impl::On(ProcessId, SetUp& message, Outbox*) {
  for (CellId c = 0; c < message.tree.size(); ++c) {
    const Cell& cell = message.tree.cell(c);
    if (cell.owner == kHost || cell.owner > message.options.processes) {
      throw WireError("a cell without an owner");
    }
  }
  if (!CheckView(message.scene.settings).empty()) throw WireError("a view that makes no sense");
  ImageTable no_images(message.scene.textures, std::move(message.images));
  const Meter* kept = meter;
  SharedObjects* kept_shared = shared;
  std::destroy_at(this);  // nothing of an earlier frame stays
  std::construct_at(this, kept, kept_shared);
  self = message.id;
  options = message.options;
  tree = std::move(message.tree);
  camera = std::make_unique<Camera>(message.scene.settings, message.frame);
  scene = std::make_shared<Scene>(std::move(message.scene), message.frame);
  scene->any_transparent = message.any_transparent;
  images = std::move(no_images);
  images_sent.assign(options.processes + 1u, std::vector<bool>(images.size() + 1));
  own = std::make_shared<ObjectSet>(scene.get());
  cache = std::make_unique<ObjectCache>(options.cache);
  packer = std::make_unique<RayPacker>(options.processes);
}

void TraceProcess::Impl::On(ProcessId, Distributed&, Outbox* outbox) {
  if (tracer != nullptr) throw WireError("Distributed twice");
  shared == nullptr ? BuildOwn() : BuildShared();
  tracer = std::make_unique<CellTracer>(scene.get(), &tree, self, own.get(), cache.get());
  tracer->set_searches_cache(SearchesCache(options.schedule));
  NoteBytes();
  Ready ready;
  ready.bytes_held = bytes_held;  // the subdivision and empty packs count, too
  uint64_t largest_foreign = 0;
  for (CellId c = 0; c < tree.size(); ++c) {
    if (!tracer->owns(c)) largest_foreign = std::max(largest_foreign, tree.cell(c).bytes);
  }
  ready.bytes_needed = ready.bytes_held + 2 * largest_foreign + PendingIntersections::kLeastBytes;
  ready.probe = MathProbe();
  ready.machine = meter->machine();
  outbox->Send(kHost, Encode(ready));
}

void TraceProcess::Impl::On(ProcessId, PrimaryRays& message, Outbox*) {
  message.samples.Check(*camera, scene->settings().samples);
  runs.insert(runs.end(), message.samples.runs().begin(), message.samples.runs().end());
  samples += message.samples.size();
  requests = std::max(0, requests - 1);
  statistics.demand_rays += message.samples.size();
  counts.primary_rays += message.samples.size();
}

// The next part of the PyraClip tasks at hand, as rays. The oldest come first: a picture that is
// cut short keeps its complete rows. *rays is empty.
void TraceProcess::Impl::TakeSamples(RayQueue* rays) {
  const size_t count = std::min(kRaysPerStep, samples);
  step_samples.clear();
  static const std::vector<Travel> fresh(kRaysPerStep);  // copied as a whole, not by members
  rays->travel.assign(fresh.begin(), fresh.begin() + static_cast<ptrdiff_t>(count));
  for (size_t taken = 0; taken < count;) {
    SampleRun& run = runs.front();
    const auto some = static_cast<uint32_t>(std::min<size_t>(run.count(), count - taken));
    for (uint32_t i = 0; i < some; ++i) {
      const uint64_t token = run.first() + i;
      step_samples.push_back(SampleOf(token));
      rays->travel[taken++].back = {kHost, token};
    }
    if (some < run.count()) {
      run.Shorten(some);
    } else {
      runs.pop_front();
    }
  }
  samples -= count;
  camera->AppendPrimaryRays(step_samples, &rays->bundle.rays);
}

// The rays of a message; primary rays are made again from their samples. *to is empty.
void TraceProcess::Impl::Unpack(const TravellingRays& rays, RayQueue* to) const {
  const auto check = [this](const Travel& travel) {
    if (travel.resume != kNoCell && travel.resume >= tree.size()) {
      throw WireError("a ray that goes on in no cell");
    }
    if (travel.back.process > options.processes) throw WireError("a ray of no process");
  };
  std::vector<Sample> primary;
  primary.reserve(rays.primary.size());
  for (const PrimaryTravel& p : rays.primary) {
    Travel& travel = to->travel.emplace_back();
    travel.back = {kHost, p.token};
    travel.resume = p.resume;
    travel.best_distance = p.best_distance;
    travel.best_rank = p.best_rank;
    check(travel);
    primary.push_back(SampleOf(p.token));
    CheckSample(primary.back(), *camera, scene->settings().samples);
  }
  camera->AppendPrimaryRays(primary, &to->bundle.rays);
  for (size_t i = 0; i < rays.bundle.size(); ++i) {
    const Ray& ray = rays.bundle.rays[i];
    check(rays.travel[i]);
    to->Push(ray, std::span(rays.bundle.media).subspan(ray.media_begin, ray.media_count),
             rays.travel[i]);
  }
}

void TraceProcess::Impl::On(ProcessId from, RayTask& message, Outbox*) {
  RayQueue rays;
  Unpack(message, &rays);
  for (size_t i = 0; i < rays.size(); ++i) {
    queue.Push(rays.bundle.rays[i], rays.media(i), rays.travel[i]);
  }
  statistics.data_rays += rays.size();
  if (from == kHost) counts.primary_rays += rays.size();
}

void TraceProcess::Impl::On(ProcessId, IntersectionTask& message, Outbox*) {
  RayQueue rays;
  Unpack(message, &rays);
  for (size_t i = 0; i < rays.size(); ++i) {
    if (tracer->OwnerAt(rays.bundle.rays[i], rays.travel[i].best_distance) != self) {
      throw WireError("a hit of another's");
    }
  }
  transferred.Append(rays);
}

void TraceProcess::Impl::On(ProcessId, RayResults& message, Outbox* outbox) {
  for (const ResultItem& item : message.results) pending.at(item.token >> 1);
  for (const ResultItem& item : message.results) {
    TakeResult(item.token, {item.color, item.distance, item.distance < kFar}, outbox);
  }
}

void TraceProcess::Impl::On(ProcessId, Stop&, Outbox* outbox) {
  stopped = true;
  statistics.busy_seconds = meter->busy_seconds();
  statistics.trace_busy_seconds =
      statistics.busy_seconds - busy_before_tracing.value_or(statistics.busy_seconds);
  statistics.peak_bytes = meter->peak_bytes();
  if (const BusyTimeline* timeline = meter->timeline()) {
    statistics.interval_seconds = timeline->interval_seconds();
    statistics.busy_by_interval = timeline->busy_seconds();
  }
  if (own != nullptr) {
    statistics.objects = own->size();
    statistics.object_bytes = own->bytes();
  }
  if (tracer != nullptr) {
    statistics.cache_hits = tracer->cache_hits();
    statistics.cache_misses = tracer->cache_misses();
  }
  outbox->Send(kHost, Encode(statistics));
}

bool TraceProcess::Impl::AskForWork(Outbox* outbox) {
  if (!AsksForWork(options.schedule) || requests >= kRequestsAhead) return false;
  const size_t ready = samples + queue.size() + transferred.size() + shadow_tasks.size();
  if (!ShortOfWork(ready, waiting_rays, options.pyramid)) return false;
  ++requests;
  outbox->Send(kHost, Encode(WorkRequest{}));
  return true;
}

bool TraceProcess::Impl::Work(Outbox* outbox) {
  if (tracer == nullptr || stopped) return false;
  if (!busy_before_tracing) busy_before_tracing = meter->busy_seconds();
  AskForWork(outbox);
  if (++steps % kStepsPerFlush == 0) packer->FlushRays(outbox);
  // What frees memory goes first: cells that rays wait for, shadow rays, then the deepest rays of
  // which there is a whole step (few rays at a time are traced badly). Then hits that others found,
  // primary rays, and at last what rays there are.
  if (!arrived_cells.empty()) {
    CellReply reply = std::move(arrived_cells.front());
    arrived_cells.pop_front();
    TakeCell(std::move(reply), outbox);
  } else if (!shadow_tasks.empty()) {
    TraceShadowTasks(outbox);
  } else {
    step.clear();
    if (queue.PopEnough(&step)) {
      TraceRays(step, outbox);
    } else if (!transferred.empty()) {
      transferred.Pop(kRaysPerStep, &step);
      ShadeLocated(step, outbox);
    } else if (samples > 0) {
      primary_step.clear();
      TakeSamples(&primary_step);
      TraceRays(primary_step, outbox);
    } else if (queue.PopAny(&step)) {
      TraceRays(step, outbox);
    } else {
      packer->Flush(outbox);
      return false;
    }
  }
  RequestCells(outbox);
  NoteBytes();
  return true;
}

void TraceProcess::Impl::NoteBytes() {
  bytes_held = own->bytes() + images.bytes() + cache->bytes() + tracer->bytes() + queue.bytes() +
               transferred.bytes() + pending.bytes() + packer->bytes() +
               (ranks ? ranks->bytes() : 0) + waiting_rays * (sizeof(Ray) + sizeof(Travel)) +
               shadow_tasks.size() * sizeof(ShadowTravel) +
               (waiting_shades.size() - free_waiting_shades.size()) * sizeof(WaitingShade);
  statistics.bytes_held_max = std::max(statistics.bytes_held_max, bytes_held);
}

}  // namespace rayshade::parallel
