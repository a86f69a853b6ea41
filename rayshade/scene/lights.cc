// Lights as they are read; see lights.h.
#include "rayshade/scene/lights.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "rayshade/common/constants.h"

namespace rayshade {
namespace {

constexpr int64_t kMostCells = 1 << 20;

// The edge of one cell: a unit vector times its length.
Vector CellEdge(const Vector& from, const Vector& to, int count) {
  Vector edge = to - from;
  const double length = Normalize(&edge);
  return (length / count) * edge;
}

// The places of the cells of a light, u fastest, along a Morton curve.
std::vector<uint32_t> CellOrder(int u_count, int v_count) {
  const auto spread = [](uint64_t x) {
    uint64_t bits = 0;
    for (int i = 0; i < 21; ++i) bits |= (x >> i & 1) << 2 * i;
    return bits;
  };
  std::vector<std::pair<uint64_t, uint32_t>> curve;
  for (int j = 0; j < v_count; ++j) {
    for (int i = 0; i < u_count; ++i) {
      curve.emplace_back(spread(i) | spread(j) << 1, static_cast<uint32_t>(curve.size()));
    }
  }
  std::sort(curve.begin(), curve.end());
  std::vector<uint32_t> order(curve.size());
  for (uint32_t place = 0; place < curve.size(); ++place) order[curve[place].second] = place;
  return order;
}

}  // namespace

void Lights::SetDirectional(const Vector& direction) {
  source_.reset();
  if (!(Length(direction) >= kEpsilon)) return reporter_->Error("Invalid directional light.");
  source_ = DirectionalLightSpec{direction};
}

void Lights::SetSpot(const SpotLightSpec& spot) {
  source_.reset();
  if (spot.inner > spot.outer || !(Length(spot.at - spot.from) >= kEpsilon)) {
    return reporter_->Error("Invalid spotlight specification.");
  }
  source_ = spot;
}

void Lights::SetArea(const Area& area) {
  source_.reset();
  area_.reset();
  if (area.u_count < 1 || area.v_count < 1 ||
      static_cast<int64_t>(area.u_count) * area.v_count > kMostCells) {
    return reporter_->Error("Invalid area light specification.");
  }
  if (!(Length(area.u_end - area.corner) >= kEpsilon) ||
      !(Length(area.v_end - area.corner) >= kEpsilon)) {
    return reporter_->Error("Degenerate area light source.");
  }
  area_ = area;
}

void Lights::Add(const Color& intensity, bool noshadow) {
  if (area_) return AddCells(intensity, noshadow);
  if (!source_) return;
  sink_->AddLight({intensity, noshadow, *source_});
  source_.reset();
}

// Cells with u fastest, their corners by repeated addition.
void Lights::AddCells(const Color& intensity, bool noshadow) {
  const Area area = *area_;
  area_.reset();
  const Vector u = CellEdge(area.corner, area.u_end, area.u_count);
  const Vector v = CellEdge(area.corner, area.v_end, area.v_count);
  const double cells = static_cast<double>(area.u_count) * area.v_count;
  const Color share{intensity.r / cells, intensity.g / cells, intensity.b / cells};
  const std::vector<uint32_t> order = CellOrder(area.u_count, area.v_count);
  const uint32_t number = areas_++;
  size_t cell = 0;
  Vector row = area.corner;
  for (int j = 0; j < area.v_count; ++j, row = row + v) {
    Vector corner = row;
    for (int i = 0; i < area.u_count; ++i, corner = corner + u) {
      const AreaCellSpec source{
          corner, u, v, number, order[cell++], static_cast<uint32_t>(order.size())};
      sink_->AddLight({share, noshadow, source});
    }
  }
}

void Air::SetIndex(int index) {
  if (index < 1) return reporter_->Fatal("Index of refraction must be positive.");
  atmosphere_.index = index;
}

}  // namespace rayshade
