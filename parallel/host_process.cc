// Set-up, distribution, feeding and gathering; see host_process.h.
#include "parallel/host_process.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "parallel/balanced_distribution.h"
#include "parallel/pending_intersections.h"
#include "parallel/primary_feed.h"
#include "parallel/trace_impl.h"
#include "parallel/voxel_distribution.h"

namespace rayshade::parallel {

// Objects on their way to one trace process, encoded as they come: a parcel of a message Objects.
struct HostProcess::Receiver {
  std::vector<WireImage> images;
  std::vector<WirePlacement> placements;
  std::vector<uint8_t> objects;
  uint32_t count = 0;
  std::vector<bool> has_placement;  // by number in the run
  std::vector<bool> has_image;      // by number
};

namespace {

constexpr size_t kParcelBytes = 12000;
constexpr int kUntakenMax = 64;  // parcels on their way at once, to all processes together
constexpr int kObjectsPerStep = 1024;

// What one primary ray can occupy at once in all processes together: a pending intersection per
// level, and a ray on its way or an intersection that waits for the cells of its shadow rays
// (trace_process.h, invariant 2).
uint64_t BytesPerPrimaryRay(const SceneSpec& scene, Shadows shadows) {
  const uint64_t levels = static_cast<uint64_t>(scene.settings.max_depth) + 1;
  return levels * (sizeof(PendingIntersection) + sizeof(PendingRest)) + sizeof(WaitingShade) +
         sizeof(Ray) + sizeof(Travel) +
         (scene.lights.size() + 1) * (sizeof(ShadowRay) + sizeof(std::vector<ShadowCrossing>) + 16 +
                                      (shadows == Shadows::kTravel ? sizeof(ShadowTravel) : 0));
}

// What a trace process holds beside objects and many rays: the subdivision with its boxes, packs,
// the first pending intersections, and one ray, to and fro.
uint64_t BytesBeside(const CellTree& tree, const SceneSpec& scene, Shadows shadows,
                     ProcessId processes) {
  return tree.bytes() + tree.size() * (sizeof(Bounds) + 2) + tree.nodes().size() +
         RayPacker(processes).bytes() + PendingIntersections::kLeastBytes +
         2 * BytesPerPrimaryRay(scene, shadows);
}

std::string Bytes(uint64_t n) { return std::to_string(n) + " bytes"; }

}  // namespace

HostProcess::HostProcess(const RunOptions& options, ObjectSpool* spool, int frame)
    : options_(options),
      spool_(spool),
      frame_(frame),
      receivers_(options.processes),
      probes_(options.processes),
      statistics_(options.processes),
      machines_(options.processes) {
  const Settings& settings = spool->scene().settings;
  camera_ = std::make_unique<Camera>(settings, frame);
  sampling_ = std::make_unique<PixelSampling>(settings, *camera_, /*ahead=*/true);
  if (options_.schedule == Schedule::kDataParallel) options_.resident = 0;
  tree_ = BuildTree(options_, spool);
  std::optional<std::pair<ProcessId, uint64_t>> fullest;
  if (options_.distribution == Distribution::kBalanced) fullest = Balance();
  PlanMemory(fullest);
  const size_t pyramid =
      std::clamp<size_t>(in_flight_limit_ / (2 * options_.processes), 1, options_.pyramid);
  if (options_.schedule == Schedule::kDataParallel) {
    feed_ = std::make_unique<DataParallelFeed>(camera_.get(), &tree_, options_.processes);
  } else {
    feed_ = std::make_unique<PyramidFeed>(pyramid, options_.processes, std::move(expected_owners_));
  }
  options_.pyramid = static_cast<uint32_t>(pyramid);
}

HostProcess::~HostProcess() = default;

size_t HostProcess::unsent() const { return feed_->unsent(); }

WorkDone HostProcess::work_done() const {
  WorkDone done;
  done.counts.cell_steps = feed_->cell_steps();
  done.samples = 2 * samples_done_ + in_flight_;
  return done;
}

// Every process gets its part of the work; of the bytes, where that would take more than half of a
// process's memory: caches, rays and the building of the hierarchy need the rest. Returns the
// fullest process where that had to be found and is so still.
std::optional<std::pair<ProcessId, uint64_t>> HostProcess::Balance() {
  const PredictedHits hits = PredictHits(*camera_, tree_, spool_);
  ShareOut(WorkByCell(hits.by_cell, tree_), options_.processes, &tree_);
  std::optional<std::pair<ProcessId, uint64_t>> fullest;
  if (options_.memory != 0) fullest = FullestProcess();
  if (fullest && fullest->second > options_.memory / 2) {
    ShareOut(BytesByCell(tree_), options_.processes, &tree_);
    fullest.reset();
  }
  expected_owners_ = ExpectedOwners(hits, tree_, camera_->window());
  return fullest;
}

// The process that needs most memory for its objects and the two largest cells of others, and how
// much that is.
std::pair<ProcessId, uint64_t> HostProcess::FullestProcess() const {
  const auto held = BytesHeld(options_, tree_, spool_);
  const auto fullest = std::max_element(held.begin(), held.end());
  return {static_cast<ProcessId>(fullest - held.begin() + 1), *fullest + SpareBytes()};
}

uint64_t HostProcess::SpareBytes() const {
  uint64_t largest_cell = 0;
  for (CellId c = 0; c < tree_.size(); ++c)
    largest_cell = std::max(largest_cell, tree_.cell(c).bytes);
  return options_.processes > 1 ? 2 * largest_cell : 0;
}

// Shares the memory of a process out: its own objects come first, the rest goes to resident set,
// cache and rays.
void HostProcess::PlanMemory(std::optional<std::pair<ProcessId, uint64_t>> fullest) {
  const uint64_t spare = SpareBytes();
  uint64_t for_rays = 0;
  if (options_.memory != 0) {
    const auto [process, needed] = fullest ? *fullest : FullestProcess();
    if (needed > options_.memory) {
      const int enough = ProcessesThatWouldDo(options_.memory, spare, spool_);
      throw std::runtime_error("out of memory: trace process " + std::to_string(process) +
                               " needs " + Bytes(needed) + " for its objects, --memory allows " +
                               Bytes(options_.memory) + "; " +
                               (enough > 0 ? std::to_string(enough) + " processes would do"
                                           : std::string("no number of processes would do")));
    }
    const uint64_t free = options_.memory - (needed - spare);
    const uint64_t rest = free - std::min(free, BytesBeside(tree_, spool_->scene(),
                                                            options_.shadows, options_.processes));
    options_.resident = std::min(options_.resident, rest / 4);
    options_.cache =
        std::max(spare, std::min(options_.cache == 0 ? rest : options_.cache, rest / 3));
    for_rays = (rest - std::min(rest, options_.resident + options_.cache)) / 2;
  } else if (options_.cache != 0) {
    options_.cache = std::max(options_.cache, SpareBytes());
  }
  ChooseResidentSet(camera_->eye(), options_.resident, &tree_);
  // Rays wait where their voxels are: enough of them that processes with little data do not run dry
  // meanwhile.
  const uint64_t plenty =
      uint64_t{32} * options_.processes * std::max<uint32_t>(options_.pyramid, 256);
  const uint64_t allowed = options_.memory == 0
                               ? plenty
                               : for_rays / BytesPerPrimaryRay(spool_->scene(), options_.shadows);
  in_flight_limit_ = static_cast<uint32_t>(std::clamp<uint64_t>(allowed, 1, plenty));
  if (options_.rays_in_flight != 0) in_flight_limit_ = options_.rays_in_flight;
}

void HostProcess::Fail(const std::string& text) {
  if (finished()) return;
  phase_ = Phase::kFailed;
  failure_ = text;
}

void HostProcess::OnLost(ProcessId process, const std::string& why) {
  if (phase_ == Phase::kStop) {  // its statistics may be lost, the picture is not
    if (++reported_ == options_.processes) phase_ = Phase::kDone;
    return;
  }
  Fail("trace process " + std::to_string(process) + " is lost: " + why);
}

void HostProcess::Receive(ProcessId from, std::span<const uint8_t> bytes, Outbox* outbox) {
  if (from == kHost || from > options_.processes) throw WireError("a message from nobody");
  switch (TagOf(bytes)) {
    case Tag::kObjectsTaken:
      return On(from, Decode<ObjectsTaken>(bytes), outbox);
    case Tag::kReady:
      return On(from, Decode<Ready>(bytes), outbox);
    case Tag::kWorkRequest:
      return On(from, Decode<WorkRequest>(bytes), outbox);
    case Tag::kPixelResults:
      return On(from, Decode<PixelResults>(bytes), outbox);
    case Tag::kStatistics:
      return On(from, Decode<Statistics>(bytes), outbox);
    case Tag::kText:
      return On(from, Decode<Text>(bytes), outbox);
    case Tag::kFailure:
      return On(from, Decode<Failure>(bytes), outbox);
    default:
      throw WireError(std::string(NameOf(TagOf(bytes))) + " is not for the host");
  }
}

void HostProcess::On(ProcessId, const ObjectsTaken&, Outbox*) {
  if (untaken_ == 0) throw WireError("objects taken that were not sent");
  --untaken_;
}

void HostProcess::On(ProcessId from, const Ready& message, Outbox*) {
  probes_[from - 1] = message.probe;
  machines_[from - 1] = message.machine;
  const uint64_t needed =
      message.bytes_needed + 2 * BytesPerPrimaryRay(spool_->scene(), options_.shadows);
  if (options_.memory != 0 && needed > options_.memory) {
    Fail("out of memory: trace process " + std::to_string(from) + " needs " + Bytes(needed) +
         " for its objects, --memory allows " + Bytes(options_.memory));
  }
  if (++ready_ < options_.processes || finished()) return;
  for (int p = 1; p < options_.processes; ++p) {
    if (probes_[p] != probes_[0]) {
      return Fail("the mathematical functions of trace process " + std::to_string(p + 1) + " (" +
                  machines_[p] + ") differ from those of process 1 (" + machines_[0] +
                  "): pictures would differ");
    }
  }
  phase_ = Phase::kTrace;
}

void HostProcess::On(ProcessId from, const WorkRequest&, Outbox*) { feed_->OnRequest(from); }

void HostProcess::On(ProcessId, const PixelResults& message, Outbox*) {
  const size_t count = message.voids.size() + message.misses.size() + message.hits.size();
  if (count > in_flight_) throw WireError("more results than rays");
  const Settings& settings = spool_->scene().settings;
  message.voids.Check(*camera_, settings.samples);
  in_flight_ -= count;
  samples_done_ += count;
  for (const SampleRun& run : message.voids.runs()) {
    sampling_->PutRun(SampleOf(run.first()), static_cast<int>(run.count()),
                      {settings.background, kFar, false});
  }
  Put(message.misses, kFar, false);
  Put(message.hits, 0, true);
}

// By bundles; each item is told by a message and therefore checked.
void HostProcess::Put(std::span<const PixelItem> items, double distance, bool hit) {
  constexpr size_t kAtOnce = 256;
  Sample samples[kAtOnce];
  RayResult results[kAtOnce];
  while (!items.empty()) {
    const size_t count = std::min(kAtOnce, items.size());
    for (size_t i = 0; i < count; ++i) {
      samples[i] = SampleOf(items[i].token);
      CheckSample(samples[i], *camera_, spool_->scene().settings.samples);
      results[i] = {items[i].color, distance, hit};
    }
    sampling_->Put({samples, count}, {results, count});
    items = items.subspan(count);
  }
}

void HostProcess::On(ProcessId from, const Statistics& message, Outbox*) {
  statistics_[from - 1] = message;
  if (++reported_ == options_.processes && !finished()) phase_ = Phase::kDone;
}

void HostProcess::On(ProcessId from, const Text& message, Outbox*) {
  texts_.push_back("process " + std::to_string(from) + ": " + message.text);
}

void HostProcess::On(ProcessId from, const Failure& message, Outbox*) {
  Fail("trace process " + std::to_string(from) + ": " + message.text);
}

std::vector<std::string> HostProcess::TakeTexts() { return std::exchange(texts_, {}); }

bool HostProcess::Work(Outbox* outbox) {
  switch (phase_) {
    case Phase::kSetUp:
      SendSetUp(outbox);
      return true;
    case Phase::kDistribute:
      return Distribute(outbox);
    case Phase::kTrace:
      return HandOut(outbox);
    default:
      return false;
  }
}

void HostProcess::SendSetUp(Outbox* outbox) {
  SetUp message;
  message.frame = frame_;
  message.options = options_;
  message.scene = spool_->scene();
  images_ = ImageTable(message.scene.textures);
  message.images = images_.numbers();
  message.any_transparent = Scene(spool_->scene(), frame_).any_transparent;
  message.tree = tree_;
  for (ProcessId p = 1; p <= options_.processes; ++p) {
    message.id = p;
    outbox->Send(p, Encode(message));
  }
  spool_->Rewind();
  phase_ = Phase::kDistribute;
}

void HostProcess::SendParcel(ProcessId to, Outbox* outbox) {
  Receiver& receiver = receivers_[to - 1];
  if (receiver.count == 0) return;
  ByteWriter w;
  w.Put(Objects::kTag);
  w.Put(receiver.images);
  w.Put(receiver.placements);
  w.Put(receiver.count);
  w.PutRaw(receiver.objects);
  outbox->Send(to, w.Take());
  receiver.images.clear();
  receiver.placements.clear();
  receiver.objects.clear();
  receiver.count = 0;
  ++untaken_;
}

void HostProcess::AddImage(uint32_t number, Receiver* receiver) {
  receiver->has_image.resize(images_.size() + 1);
  if (receiver->has_image[number]) return;
  receiver->has_image[number] = true;
  receiver->images.push_back({number, images_.image(number)});
}

// Objects go to the owners of the cells they touch, and to all where a cell is resident or where
// they have no bounds.
bool HostProcess::Distribute(Outbox* outbox) {
  if (untaken_ > kUntakenMax) return false;
  std::vector<uint8_t> wanted(options_.processes);
  ByteWriter encoded;
  SpooledObject object;
  for (int i = 0; i < kObjectsPerStep; ++i) {
    if (!spool_->Next(true, &object)) {
      for (ProcessId p = 1; p <= options_.processes; ++p) {
        SendParcel(p, outbox);
        outbox->Send(p, Encode(Distributed{}));
      }
      phase_ = Phase::kBuild;
      feed_->Prepare(sampling_.get());
      return true;
    }
    std::fill(wanted.begin(), wanted.end(), !object.bounded);
    if (object.bounded) {
      tree_.ForEachOver(object.bounds, [&](CellId c) {
        if (tree_.cell(c).resident) std::fill(wanted.begin(), wanted.end(), 1);
        wanted[tree_.cell(c).owner - 1] = 1;
      });
    }
    encoded.clear();
    encoded.Put(object.object);
    for (ProcessId p = 1; p <= options_.processes; ++p) {
      if (!wanted[p - 1]) continue;
      Receiver& receiver = receivers_[p - 1];
      const auto send_image = [&](uint32_t image) { AddImage(image, &receiver); };
      const uint32_t number = object.object.placement;
      if (number >= receiver.has_placement.size()) receiver.has_placement.resize(number + 1);
      if (!receiver.has_placement[number]) {
        receiver.has_placement[number] = true;
        receiver.placements.push_back({number, spool_->placement(number)});
        images_.ForEachOf(spool_->placement(number), send_image);
      }
      images_.ForEachOf(object.object.geom, send_image);
      receiver.objects.insert(receiver.objects.end(), encoded.bytes().begin(),
                              encoded.bytes().end());
      ++receiver.count;
      if (receiver.objects.size() >= kParcelBytes) SendParcel(p, outbox);
    }
  }
  return true;
}

bool HostProcess::HandOut(Outbox* outbox) {
  if (sampling_->done() && in_flight_ == 0) {
    for (ProcessId p = 1; p <= options_.processes; ++p) outbox->Send(p, Encode(Stop{}));
    phase_ = Phase::kStop;
    return true;
  }
  // New rays in portions worth sending: waits until a good part of the limit is free.
  const size_t room = in_flight_limit_ - in_flight_;
  const size_t portion = std::min<size_t>(options_.pyramid, in_flight_limit_);
  const size_t handed_out = room < portion ? 0 : feed_->HandOut(room, sampling_.get(), outbox);
  in_flight_ += handed_out;
  if (handed_out == 0) feed_->Flush(outbox);
  return handed_out > 0;
}

}  // namespace rayshade::parallel
