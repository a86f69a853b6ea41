// Textures change the surface and the normal of one hit [rayshade4/3 s.9-11]. A texture is
// immutable; random numbers come from the ray's key. One file pair per texture; specs (what the
// language wrote) are in texture/spec.h.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rayshade/common/expression.h"
#include "rayshade/common/transform.h"
#include "rayshade/geom/geom.h"
#include "rayshade/surface/surface.h"
#include "rayshade/texture/spec.h"

namespace rayshade {

// One application of a texture. "Model space" is the space outside the textured object: after its
// own transforms.
struct TextureHit {
  // Changed by the texture:
  Surface surface;
  Vector normal;  // model space, turned towards the viewer before texturing
  // Given:
  Vector point;                  // model space
  Vector ray_origin;             // model space
  Vector ray_direction;          // model space, unit
  Transform primitive_to_model;  // P of [rayshade4/3 s.9.1]
  const HitPath* path =
      nullptr;  // the hit in primitive space, its geometric_normal turned towards the viewer
  Moment moment;
  uint64_t key = 0;  // of the ray, for gloss
  uint32_t application =
      0;  // counts the textures applied at this hit: part of the key of random numbers
  uint32_t sample_number = 0;
  int samples = 1;  // N, the sample setting
};

class Texture {
 public:
  virtual ~Texture() = default;
  virtual void Apply(TextureHit* hit) const = 0;
  virtual size_t bytes() const = 0;  // all included, images too
};

// surfaces: the scene's table, for the textures that carry a surface; copied from, not kept.
std::unique_ptr<const Texture> MakeTexture(const TextureSpec& spec,
                                           const std::vector<Surface>& surfaces);

}  // namespace rayshade
