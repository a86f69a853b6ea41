// One cell of an area light: a point light at a random place of its parallelogram
// [rayshade4/3 s.6.6]. The six random numbers are independent, so that the place need not lie in
// the cell where an edge is not parallel to an axis (s.14, K2).
#pragma once

#include "rayshade/light/light.h"

namespace rayshade {

class AreaCellLight : public Light {
 public:
  AreaCellLight(const LightSpec& spec, const AreaCellSpec& source) : Light(spec), cell_(source) {}

  LightDirection Toward(const Vector& point, const LightKey& key) const override;
  std::optional<LightArrival> Arrive(const Vector& point, const LightDirection& direction,
                                     const LightKey& key) const override;
  double Share(const LightKey& key) const override;

 private:
  AreaCellSpec cell_;
};

}  // namespace rayshade
