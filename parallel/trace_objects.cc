// Objects that a trace process is sent, keeps and lends; see trace_impl.h.
#include <algorithm>

#include "parallel/trace_impl.h"
#include "rayshade/geom/make_geom.h"

namespace rayshade::parallel {

PlacementId TraceProcess::Impl::LocalPlacement(uint32_t number) const {
  const auto it = numbers.placements.find(number);
  if (it == numbers.placements.end()) throw WireError("an object without its placement");
  return it->second;
}

// An image makes the textures that show it.
void TraceProcess::Impl::TakeImage(const WireImage& image) {
  if (!images.Put(image.number, image.image)) return;
  for (TextureId t = 0; t < images.numbers().size(); ++t) {
    if (images.numbers()[t] == image.number) scene->GiveImage(t, image.image);
  }
}

void TraceProcess::Impl::CheckAttributes(const Attributes& attributes) const {
  if (attributes.surface != kNoSurface && attributes.surface >= scene->spec.surfaces.size()) {
    throw WireError("an object of no surface");
  }
  for (const TextureId t : attributes.textures) {
    if (t >= scene->textures.size()) throw WireError("an object of no texture");
    if (scene->textures[t] == nullptr) throw WireError("an object without its image");
  }
}

void TraceProcess::Impl::CheckInside(const GeomSpec& geom) const {
  const auto* composite = std::get_if<CompositeSpec>(&geom);
  if (composite == nullptr) return;
  if (composite->members == nullptr) throw WireError("a composite without members");
  for (const PlacedSpec& member : *composite->members) {
    CheckAttributes(member.attributes);
    CheckInside(member.geom);
  }
}

void TraceProcess::Impl::Install(const ObjectParcel& parcel, ObjectSet* set) {
  for (const WireImage& image : parcel.images) TakeImage(image);
  for (const WirePlacement& p : parcel.placements) {
    for (const PathLevel& level : p.placement.levels) CheckAttributes(level.attributes);
    const auto [it, added] =
        numbers.placements.try_emplace(p.number, scene->spec.placements.size());
    if (!added) continue;
    scene->spec.placements.push_back(p.placement);
    numbers.placement_numbers.push_back(p.number);
  }
  for (const WireObject& object : parcel.objects) {
    CheckInside(object.geom);
    const PlacementId placement = LocalPlacement(object.placement);
    if (object.member == 0) {
      set->Add(object.geom, placement, object.rank);
      continue;
    }
    Member& member = numbers.members[object.member];
    if (member.geom == nullptr) {
      member = {object.geom, MakeGeom(object.geom, scene->shutter)};
      numbers.member_numbers.emplace(member.geom.get(), object.member);
    }
    set->Add(member.geom, object.geom.index(), placement, object.rank);
  }
}

void TraceProcess::Impl::On(ProcessId, Objects& message, Outbox* outbox) {
  if (tracer != nullptr) throw WireError("Objects after Distributed");
  Install(message.parcel, own.get());
  objects_taken += message.parcel.objects.size();
  outbox->Send(kHost, Encode(ObjectsTaken{}));
}

// The hierarchy over what was sent, and the index of it.
void TraceProcess::Impl::BuildOwn() {
  own->Build();
  const bool plenty = options.memory == 0 || own->bytes() < options.memory / 8;
  if (TransfersHits(options.schedule) && plenty) ranks = std::make_shared<RankIndex>(own.get());
}

void TraceProcess::Impl::On(ProcessId from, CellRequest& message, Outbox* outbox) {
  if (message.cell >= tree.size() || !tracer->owns(message.cell))
    throw WireError("a request for a foreign cell");
  if (from >= images_sent.size()) throw WireError("a request from nobody");
  CellReply reply;
  reply.cell = message.cell;
  Bounds box = tracer->box(message.cell);
  box.Grow(2 * tree.margin());
  std::vector<uint8_t> sent(numbers.placement_numbers.size());
  const auto send_image = [&](uint32_t number) {
    if (images_sent[from][number]) return;
    images_sent[from][number] = true;
    reply.parcel.images.push_back({number, images.image(number)});
  };
  own->ForEachIn(box, [&](uint32_t object) {
    ObjectSet::Entry entry = own->entry(object);
    WireObject wire;
    wire.rank = entry.rank;
    wire.placement = numbers.placement_numbers[entry.placement];
    const auto member = numbers.member_numbers.find(entry.member.get());
    if (member != numbers.member_numbers.end()) {
      wire.member = member->second;
      wire.geom = numbers.members.at(wire.member).spec;
    } else {
      wire.geom = std::move(entry.spec);
    }
    images.ForEachOf(wire.geom, send_image);
    reply.parcel.objects.push_back(std::move(wire));
    if (sent[entry.placement]++ == 0) {
      reply.parcel.placements.push_back(
          {numbers.placement_numbers[entry.placement], scene->placement(entry.placement)});
      images.ForEachOf(scene->placement(entry.placement), send_image);
    }
  });
  objects_lent += reply.parcel.objects.size();
  outbox->Send(from, Encode(reply));
}

void TraceProcess::Impl::On(ProcessId, CellReply& message, Outbox*) {
  const bool here =
      std::any_of(arrived_cells.begin(), arrived_cells.end(),
                  [&message](const CellReply& reply) { return reply.cell == message.cell; });
  if (!waiting.contains(message.cell) || cells_requested == 0 || here) {
    throw WireError("a cell that nobody asked for");
  }
  --cells_requested;
  arrived_cells.push_back(std::move(message));
}

}  // namespace rayshade::parallel
