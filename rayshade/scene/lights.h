// Light and atmosphere statements [rayshade4/3 s.6, 8].
#pragma once

#include <optional>

#include "rayshade/scene/gated_sink.h"

namespace rayshade {

class Lights {
 public:
  Lights(GatedSink* sink, Reporter* reporter) : sink_(sink), reporter_(reporter) {}

  struct Area {
    Vector corner, u_end;
    int u_count = 0;
    Vector v_end;
    int v_count = 0;
  };

  // First the source, then the light that it belongs to.
  void SetPoint(const Vector& position) { source_ = PointLightSpec{position}; }
  void SetDirectional(const Vector& direction);
  void SetExtended(double radius, const Vector& center) {
    source_ = ExtendedLightSpec{radius, center};
  }
  void SetSpot(const SpotLightSpec& spot);
  void SetArea(const Area& area);
  void Add(const Color& intensity, bool noshadow);

 private:
  void AddCells(const Color& intensity, bool noshadow);

  GatedSink* sink_;
  Reporter* reporter_;
  std::optional<decltype(LightSpec::source)> source_;  // nothing where it was refused
  std::optional<Area> area_;
  uint32_t areas_ = 0;  // area lights so far
};

// Each statement replaces the effects of the one before; the index stays.
class Air {
 public:
  Air(GatedSink* sink, Reporter* reporter) : sink_(sink), reporter_(reporter) {}

  void Begin() { atmosphere_.effects.clear(); }
  void SetIndex(int index);
  void Add(const Effect& effect) { atmosphere_.effects.push_back(effect); }
  void End() { sink_->SetAtmosphere(atmosphere_); }

 private:
  GatedSink* sink_;
  Reporter* reporter_;
  Atmosphere atmosphere_;
};

}  // namespace rayshade
