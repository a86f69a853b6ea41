// Objects that processes in one address space share: a message Objects is kept as it came, and
// decoded by the first process that was sent these and no others. See shared_objects.h and
// trace_impl.h.
#include "parallel/trace_impl.h"

namespace rayshade::parallel {

void TraceProcess::Impl::KeepShared(std::span<const uint8_t> objects, Outbox* outbox) {
  if (tracer != nullptr) throw WireError("Objects after Distributed");
  const SharedObjects::Parcel parcel = shared->Keep(objects);
  shared_parcels.push_back(parcel.number);
  objects_taken += parcel.objects;
  outbox->Send(kHost, Encode(ObjectsTaken{}));
}

void TraceProcess::Impl::BuildShared() {
  std::shared_ptr<const Holding>& holding = shared->Of(shared_parcels);
  if (holding != nullptr) {
    for (const WireImage& image : holding->images) TakeImage(image);
    scene->spec.placements = holding->placements;
    numbers = holding->numbers;
    own = holding->own;
    ranks = holding->ranks;
    return;
  }
  Holding made;
  for (const uint32_t number : shared_parcels) {
    const Objects message = shared->At(number);
    Install(message.parcel, own.get());
    made.images.insert(made.images.end(), message.parcel.images.begin(),
                       message.parcel.images.end());
  }
  BuildOwn();
  made.own = own;
  made.ranks = ranks;
  made.scene = scene;
  made.placements = scene->spec.placements;
  made.numbers = numbers;
  holding = std::make_shared<Holding>(std::move(made));
}

}  // namespace rayshade::parallel
