// From what the language wrote to what changes surfaces; see texture.h.
#include "rayshade/common/check.h"
#include "rayshade/texture/blotch.h"
#include "rayshade/texture/bump.h"
#include "rayshade/texture/checker.h"
#include "rayshade/texture/cloud.h"
#include "rayshade/texture/fbm.h"
#include "rayshade/texture/fbm_bump.h"
#include "rayshade/texture/gloss.h"
#include "rayshade/texture/image.h"
#include "rayshade/texture/marble.h"
#include "rayshade/texture/mount.h"
#include "rayshade/texture/sky.h"
#include "rayshade/texture/stripe.h"
#include "rayshade/texture/texture.h"
#include "rayshade/texture/windy.h"
#include "rayshade/texture/wood.h"

namespace rayshade {
namespace {

using Made = std::unique_ptr<const Texture>;

struct Maker {
  const TransformChain& transforms;
  const std::vector<Surface>& surfaces;

  const Surface& At(SurfaceId id) const {
    CHECK(id < surfaces.size());
    return surfaces[id];
  }

  Made operator()(const CheckerSpec& s) const {
    return std::make_unique<CheckerTexture>(At(s.surface), transforms);
  }
  Made operator()(const BlotchSpec& s) const {
    return std::make_unique<BlotchTexture>(s, At(s.surface), transforms);
  }
  Made operator()(const BumpSpec& s) const { return std::make_unique<BumpTexture>(s, transforms); }
  Made operator()(const GlossSpec& s) const {
    return std::make_unique<GlossTexture>(s, transforms);
  }
  Made operator()(const WoodSpec&) const { return std::make_unique<WoodTexture>(transforms); }
  Made operator()(const MarbleSpec& s) const {
    return std::make_unique<MarbleTexture>(s, transforms);
  }
  Made operator()(const FbmSpec& s) const { return std::make_unique<FbmTexture>(s, transforms); }
  Made operator()(const FbmBumpSpec& s) const {
    return std::make_unique<FbmBumpTexture>(s, transforms);
  }
  Made operator()(const CloudSpec& s) const {
    return std::make_unique<CloudTexture>(s, transforms);
  }
  Made operator()(const SkySpec& s) const { return std::make_unique<SkyTexture>(s, transforms); }
  Made operator()(const StripeSpec& s) const {
    return std::make_unique<StripeTexture>(s, At(s.surface), transforms);
  }
  Made operator()(const WindySpec& s) const {
    return std::make_unique<WindyTexture>(s, transforms);
  }
  Made operator()(const MountSpec& s) const {
    return std::make_unique<MountTexture>(s, transforms);
  }
  Made operator()(const ImageSpec& s) const {
    CHECK(s.image != nullptr);
    const Surface* surface = s.surface == kNoSurface ? nullptr : &At(s.surface);
    return std::make_unique<ImageTexture>(s, surface, transforms);
  }
};

}  // namespace

Made MakeTexture(const TextureSpec& spec, const std::vector<Surface>& surfaces) {
  return std::visit(Maker{spec.transforms, surfaces}, spec.kind);
}

}  // namespace rayshade
