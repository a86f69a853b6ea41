// See shared_objects.h.
#include "parallel/shared_objects.h"

namespace rayshade::parallel {

namespace {

std::string_view TextOf(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::span<const uint8_t> BytesOf(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

}  // namespace

SharedObjects::Parcel SharedObjects::Keep(std::span<const uint8_t> message) {
  const auto known = parcels_.find(TextOf(message));
  if (known != parcels_.end()) return known->second;
  const size_t objects = Decode<Objects>(message).parcel.objects.size();
  const Parcel parcel{static_cast<uint32_t>(by_number_.size()), objects};
  by_number_.push_back(&parcels_.emplace(TextOf(message), parcel).first->first);
  return parcel;
}

Objects SharedObjects::At(uint32_t number) const {
  return Decode<Objects>(BytesOf(*by_number_[number]));
}

}  // namespace rayshade::parallel
