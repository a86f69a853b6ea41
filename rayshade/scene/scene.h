// A scene without its objects: everything that every process of a run holds. Objects are in an
// ObjectSet (accel/), so that a process can hold a part of them.
#pragma once

#include <memory>
#include <vector>

#include "rayshade/light/light.h"
#include "rayshade/scene/placement.h"
#include "rayshade/scene/settings.h"
#include "rayshade/surface/atmosphere.h"
#include "rayshade/surface/surface.h"
#include "rayshade/texture/texture.h"

namespace rayshade {

// As written: what travels in messages.
struct SceneSpec {
  Settings settings;
  std::vector<Surface> surfaces;
  std::vector<TextureSpec> textures;
  std::vector<LightSpec> lights;  // in file order
  Atmosphere atmosphere;
  std::vector<Placement> placements;
};

struct Scene {
  // Builds textures and lights; adds the default directional light where the file has none
  // [rayshade4/1 s.4.9].
  Scene(SceneSpec spec, int frame);

  SceneSpec spec;
  std::vector<std::unique_ptr<const Texture>> textures;
  std::vector<std::unique_ptr<const Light>> lights;  // in visiting order: last declared first
  Surface default_surface;
  bool any_transparent = false;  // some surface in use may let shadow rays through
  ShutterInterval shutter;       // of this frame

  const Settings& settings() const { return spec.settings; }
  const Placement& placement(PlacementId id) const { return spec.placements[id]; }
  // The surface bound to a hit before texturing.
  const Surface& bound_surface(SurfaceId id) const {
    return id == kNoSurface ? default_surface : spec.surfaces[id];
  }
  size_t bytes() const;
};

}  // namespace rayshade
