// See windy.h.
#include "rayshade/texture/windy.h"

#include "rayshade/texture/noise.h"

namespace rayshade {

void WindyTexture::Apply(TextureHit* hit) const {
  const Vector p = PointOf(*hit);
  const double wind =
      spec_.chop_scale == 0 ? 1.0 : spec_.chop_scale * Chaos(spec_.wave_scale * p, 7);
  Vector waves = spec_.bump_scale * DNoise(p);
  double frequency = 1.0, amplitude = wind;
  for (int i = 0; i < spec_.octaves && !Spent(amplitude); ++i) {
    frequency *= spec_.tscale;
    waves = waves + amplitude * DNoise(frequency * p);
    amplitude *= spec_.hscale;
    if (Absorbed(i, amplitude, spec_.hscale, waves.x, waves.y, waves.z)) break;
  }
  waves = (wind + spec_.offset) * waves;
  hit->normal = Normalized(hit->normal + spec_.scale * waves);
}

size_t WindyTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
