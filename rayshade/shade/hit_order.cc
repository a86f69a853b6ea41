// Sort, cut, sort the pieces along another axis; see hit_order.h.
#include "rayshade/shade/hit_order.h"

#include <algorithm>
#include <utility>

#include "rayshade/common/check.h"

namespace rayshade {
namespace {

constexpr size_t kGroup = 8;  // rays that are traced as one
constexpr uint32_t kBins = 64;

struct Place {
  float at[3];
  uint32_t hit;
};

struct Extent {
  int axis;
  float low, size;
};

// Of the axis along which the places lie widest apart.
Extent WidestOf(std::span<const Place> places) {
  Extent widest{0, 0, -1};
  for (int axis = 0; axis < 3; ++axis) {
    float low = places[0].at[axis], high = low;
    for (const Place& place : places) {
      low = std::min(low, place.at[axis]);
      high = std::max(high, place.at[axis]);
    }
    if (high - low > widest.size) widest = {axis, low, high - low};
  }
  return widest;
}

// Roughly: places in one bin stay as they are.
void SortAlong(const Extent& extent, std::span<const Place> from, Place* to) {
  uint8_t bins[HitOrder::kMost];
  uint32_t begin[kBins + 1] = {};
  const float scale = (kBins - 1) / extent.size;
  for (size_t i = 0; i < from.size(); ++i) {
    const float x = (from[i].at[extent.axis] - extent.low) * scale;
    const uint32_t bin = x > 0 ? static_cast<uint32_t>(std::min(x, kBins - 1.0f)) : 0;
    bins[i] = static_cast<uint8_t>(bin);
    ++begin[bin + 1];
  }
  for (uint32_t bin = 1; bin < kBins; ++bin) begin[bin] += begin[bin - 1];
  for (size_t i = 0; i < from.size(); ++i) to[begin[bins[i]]++] = from[i];
}

// The result lies in `from`.
void Order(std::span<Place> from, Place* scratch) {
  const size_t count = from.size();
  if (count <= kGroup) return;
  const Extent extent = WidestOf(from);
  if (!(extent.size > 0)) return;
  SortAlong(extent, from, scratch);
  std::copy_n(scratch, count, from.begin());
  const size_t ways = count > 4 * kGroup ? 4 : 2;
  const size_t piece = (count + ways * kGroup - 1) / (ways * kGroup) * kGroup;
  for (size_t begin = 0; begin < count; begin += piece) {
    Order(from.subspan(begin, std::min(piece, count - begin)), scratch);
  }
}

}  // namespace

void HitOrder::Set(std::span<const SurfaceHit> hits, bool by_place) {
  CHECK(hits.size() <= kMost);
  Place places[kMost], scratch[kMost];
  for (size_t i = 0; i < hits.size(); ++i) {
    const Vector& p = hits[i].point;
    places[i] = {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                 static_cast<uint32_t>(i)};
  }
  if (by_place) Order({places, hits.size()}, scratch);
  for (size_t row = 0; row < hits.size(); ++row) {
    const uint32_t hit = places[row].hit;
    hit_[row] = static_cast<uint16_t>(hit);
    row_[hit] = static_cast<uint16_t>(row);
  }
}

}  // namespace rayshade
