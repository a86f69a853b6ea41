// Two temporary files: objects as they were written, and, for a frame, placed objects with their
// world bounds; see object_spool.h.
#include "parallel/object_spool.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "parallel/spool_file.h"
#include "rayshade/common/check.h"
#include "rayshade/geom/make_geom.h"
#include "rayshade/scene/skeleton.h"

namespace rayshade::parallel {

namespace {

// What an object occupies in a process, hierarchy included; within a factor of two, which is what
// cutting cells and setting budgets needs.
uint64_t EstimatedBytes(const GeomSpec& spec, size_t encoded) {
  constexpr uint64_t kHierarchy = 20;
  if (std::holds_alternative<SphereSpec>(spec)) return 40 + kHierarchy;
  if (std::holds_alternative<TriangleSpec>(spec)) return 120 + kHierarchy;
  return 160 + kHierarchy + 2 * encoded;
}

// One record of the first file: LocalPlacement (32 bits), in_definition (8 bits), GeomSpec.
class DiskStore : public ObjectStore {
 public:
  void Add(uint64_t sequence, LocalPlacement local, bool in_definition, GeomSpec&& spec) override {
    if (sequence % kMarkEvery == 0) marks_.push_back(file_.size());
    writer_.clear();
    writer_.Put(local);
    writer_.Put(static_cast<uint8_t>(in_definition));
    writer_.Put(spec);
    file_.Append(writer_.bytes());
  }

  void ReadBack(uint64_t first, uint64_t end, const Visit& visit) override {
    file_.Seek(marks_[first / kMarkEvery]);
    Record record;
    for (uint64_t sequence = first / kMarkEvery * kMarkEvery; sequence < end; ++sequence) {
      CHECK(Read(&record));
      if (sequence >= first) visit(record.local, record.spec);
    }
  }

  struct Record {
    LocalPlacement local = 0;
    size_t encoded = 0;
    GeomSpec spec;
  };
  void Rewind() { file_.Seek(0); }
  bool Read(Record* record) {
    if (!file_.Next(&bytes_)) return false;
    ByteReader r(bytes_);
    uint8_t in_definition;
    r.Get(record->local);
    r.Get(in_definition);
    record->encoded = bytes_.size();
    r.Get(record->spec);
    return true;
  }

 private:
  static constexpr uint64_t kMarkEvery = 1024;  // objects between places that can be sought
  SpoolFile file_;
  std::vector<uint64_t> marks_;
  ByteWriter writer_;
  std::vector<uint8_t> bytes_;
};

}  // namespace

struct ObjectSpool::Impl {
  DiskStore store;
  Skeleton skeleton{&store};
  SpoolFile placed;
  SceneSpec spec;  // of the frame
  uint64_t size = 0;
  std::vector<uint8_t> bytes;

  void Write(const DiskStore::Record& record, const ObjectRun& run, const Expansion& expansion,
             uint64_t sequence, bool shared, const ShutterInterval& shutter);
};

ObjectSpool::ObjectSpool() : impl_(std::make_unique<Impl>()) {}
ObjectSpool::~ObjectSpool() = default;

Skeleton& ObjectSpool::skeleton() { return impl_->skeleton; }

const Settings& ObjectSpool::settings() const { return impl_->skeleton.settings(); }
const SceneSpec& ObjectSpool::scene() const { return impl_->spec; }
const Placement& ObjectSpool::placement(uint32_t number) const {
  return impl_->spec.placements[number];
}
uint64_t ObjectSpool::size() const { return impl_->size; }

// One record of the second file: bounded (8 bits), bounds, estimated bytes, WireObject.
void ObjectSpool::Impl::Write(const DiskStore::Record& record, const ObjectRun& run,
                              const Expansion& expansion, uint64_t sequence, bool shared,
                              const ShutterInterval& shutter) {
  const PlacementId number = run.placement(record.local);
  const Placement& placement = spec.placements[number];
  SpooledObject object;
  object.bounded = IsBounded(record.spec);
  if (object.bounded)
    object.bounds = WorldBounds(placement, BoundsOf(record.spec, shutter), shutter);
  object.bytes = EstimatedBytes(record.spec, record.encoded);
  ByteWriter w;
  w.Put(object.bounded);
  w.Put(object.bounds);
  w.Put(object.bytes);
  w.Put(expansion.rank(run, sequence, IsInclusive(record.spec)));
  w.Put(uint32_t{number});
  w.Put(shared && !placement.in_place ? static_cast<uint32_t>(sequence + 1) : uint32_t{0});
  w.Put(record.spec);
  placed.Append(w.bytes());
  ++size;
}

void ObjectSpool::Place(int frame) {
  Expansion expansion = impl_->skeleton.Expand(frame);
  impl_->spec = impl_->skeleton.Spec(std::move(expansion.placements));
  impl_->placed.Clear();
  impl_->size = 0;
  const ShutterInterval shutter = FrameShutter(impl_->spec.settings, frame);
  RunCursor cursor(&expansion.runs);
  DiskStore::Record record;
  impl_->store.Rewind();
  for (uint64_t sequence = 0; impl_->store.Read(&record); ++sequence) {
    const ObjectRun *run, *end;
    cursor.Find(sequence, &run, &end);
    const bool shared = end - run > 1;
    for (; run != end; ++run) impl_->Write(record, *run, expansion, sequence, shared, shutter);
  }
  Rewind();
}

void ObjectSpool::Rewind() { impl_->placed.Seek(0); }

bool ObjectSpool::Next(bool geometry, SpooledObject* object) {
  if (!impl_->placed.Next(&impl_->bytes)) return false;
  ByteReader r(impl_->bytes);
  r.Get(object->bounded);
  r.Get(object->bounds);
  r.Get(object->bytes);
  if (geometry) r.Get(object->object);
  return true;
}

}  // namespace rayshade::parallel
