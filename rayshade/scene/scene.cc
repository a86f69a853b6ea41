// Building what a scene's specification describes; see scene.h.
#include "rayshade/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace rayshade {
namespace {

bool LetsLightThrough(const Surface& surface) { return surface.transp >= kEpsilon; }

// Some placed object, or something inside of one, may let shadow rays through.
bool AnyTransparent(const SceneSpec& spec) {
  return spec.transparent_inside ||
         std::any_of(spec.placements.begin(), spec.placements.end(), [&](const Placement& p) {
           return p.surface != kNoSurface && LetsLightThrough(spec.surfaces[p.surface]);
         });
}

bool AnyTranslucent(const SceneSpec& spec) {
  return std::any_of(spec.surfaces.begin(), spec.surfaces.end(),
                     [](const Surface& s) { return !(s.translucency < kEpsilon); });
}

bool Finite(const Color& c) { return std::isfinite(c.r + c.g + c.b); }

bool AllFinite(const SceneSpec& spec) {
  const auto surface = [](const Surface& s) {
    return Finite(s.ambient) && Finite(s.diffuse) && Finite(s.specular) && Finite(s.body) &&
           Finite(s.translucent) && std::isfinite(s.transp) && std::isfinite(s.translucency);
  };
  const auto light = [](const LightSpec& l) { return Finite(l.intensity); };
  const auto effect = [](const Effect& e) {
    return std::visit([](const auto& air) { return Finite(air.color); }, e);
  };
  return std::all_of(spec.surfaces.begin(), spec.surfaces.end(), surface) &&
         std::all_of(spec.lights.begin(), spec.lights.end(), light) &&
         std::all_of(spec.atmosphere.effects.begin(), spec.atmosphere.effects.end(), effect) &&
         Finite(spec.settings.background) && Finite(spec.settings.ambient_light);
}

}  // namespace

ShutterInterval FrameShutter(const Settings& settings, int frame) {
  const double open = settings.start_time + frame * settings.frame_length;
  return {static_cast<double>(frame), open, open + std::max(settings.shutter, 0.0)};
}

bool ObjectsAreStale(const Settings& settings, int frame) {
  if (settings.samples != 1 || settings.jitter || !(settings.shutter > 0)) return false;
  const double start = settings.start_time + frame * settings.frame_length;
  const double moved_for = frame == settings.first_frame ? 0 : start - settings.frame_length;
  return std::abs(start - moved_for) < kEpsilon;
}

Scene::Scene(SceneSpec written, int frame) : spec(std::move(written)) {
  for (const TextureSpec& texture : spec.textures) {
    const auto* image = std::get_if<ImageSpec>(&texture.kind);
    const bool waits = image != nullptr && image->image == nullptr;
    textures.push_back(waits ? nullptr : MakeTexture(texture, spec.surfaces));
  }
  const bool keep_dark = AnyTranslucent(spec);
  for (auto light = spec.lights.rbegin(); light != spec.lights.rend(); ++light) {
    if (light->intensity != Color{} || keep_dark) lights.push_back(MakeLight(*light));
  }
  if (spec.lights.empty()) {
    lights.push_back(MakeLight({{1, 1, 1}, false, DirectionalLightSpec{{1, -1, 1}}}));
  }
  default_surface = DefaultSurface();
  any_transparent = AnyTransparent(spec);
  finite = AllFinite(spec);
  shutter = FrameShutter(spec.settings, frame);
  objects_are_stale = ObjectsAreStale(spec.settings, frame);
}

void Scene::GiveImage(TextureId texture, std::shared_ptr<const ImageData> image) {
  std::get<ImageSpec>(spec.textures[texture].kind).image = std::move(image);
  textures[texture] = MakeTexture(spec.textures[texture], spec.surfaces);
}

size_t Scene::bytes() const {
  size_t bytes = sizeof(Scene) + spec.surfaces.capacity() * sizeof(Surface) +
                 spec.textures.capacity() * sizeof(TextureSpec) +
                 spec.lights.capacity() * (sizeof(LightSpec) + sizeof(LightSpec)) +
                 spec.placements.capacity() * sizeof(Placement);
  for (const auto& texture : textures) bytes += texture == nullptr ? 0 : texture->bytes();
  for (const Placement& placement : spec.placements) {
    for (const PathLevel& level : placement.levels) {
      bytes += sizeof(PathLevel) + level.attributes.transforms.size() * sizeof(TransformLink) +
               level.attributes.textures.capacity() * sizeof(TextureId);
    }
  }
  return bytes;
}

}  // namespace rayshade
