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
  // Some member of a CSG object has a surface of its own that lets shadow rays through (the
  // placements do not show the surfaces inside of composites).
  bool transparent_inside = false;
};

// The moments that frame `frame` covers [rayshade4/1 s.5.9].
ShutterInterval FrameShutter(const Settings& settings, int frame);

// A defect that pictures depend on [rayshade4/1 s.5.12]: without jitter and with one sample, all
// rays have the frame's time; where that is the time for which objects were moved last (0 before
// the first frame), they stay as they were left when their bounds were made, at the end of the
// shutter interval. Textures that move do not.
bool ObjectsAreStale(const Settings& settings, int frame);

struct Scene {
  // Builds textures and lights, but no image texture whose image is not there yet; adds the default
  // directional light where the file has none [rayshade4/1 s.4.9].
  Scene(SceneSpec spec, int frame);

  SceneSpec spec;
  std::vector<std::unique_ptr<const Texture>> textures;  // null: waits for its image
  // In visiting order: last declared first. Lights of zero intensity are left out where no surface
  // is translucent: nothing could tell that they are there.
  std::vector<std::unique_ptr<const Light>> lights;
  Surface default_surface;
  bool any_transparent = false;  // some surface in use may let shadow rays through
  bool finite = false;           // every colour of surfaces, lights and air is a finite number
  ShutterInterval shutter;       // of this frame
  bool objects_are_stale;        // of this frame

  const Settings& settings() const { return spec.settings; }
  const Placement& placement(PlacementId id) const { return spec.placements[id]; }
  // The surface bound to a hit before texturing.
  const Surface& bound_surface(SurfaceId id) const {
    return id == kNoSurface ? default_surface : spec.surfaces[id];
  }
  // The image of an image texture that came without; builds the texture.
  void GiveImage(TextureId texture, std::shared_ptr<const ImageData> image);
  size_t bytes() const;
};

}  // namespace rayshade
