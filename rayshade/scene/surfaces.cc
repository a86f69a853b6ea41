// Surfaces by name and scope; see surfaces.h.
#include "rayshade/scene/surfaces.h"

#include <functional>

#include "rayshade/common/constants.h"

namespace rayshade {

size_t Surfaces::Hash::operator()(const Surface& s) const {
  size_t hash = s.noshadow;
  for (const double number :
       {s.ambient.r, s.ambient.g, s.ambient.b, s.diffuse.r, s.diffuse.g, s.diffuse.b, s.specular.r,
        s.specpow, s.body.r, s.transp, s.reflect, s.index, s.translucency}) {
    hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(number);
  }
  return hash;
}

SurfaceId Surfaces::IdOf(const Surface& surface) {
  const auto [place, added] = ids_.emplace(surface, static_cast<SurfaceId>(surfaces_.size()));
  if (added) {
    surfaces_.push_back(surface);
    sink_->AddSurface(surface);
  }
  return place->second;
}

void Surfaces::Define(NameId name, SurfaceId id) {
  SurfaceId& entry = names_[name];
  if (entry) reporter_->Warn("Redefinition of \"" + lexer_->text(name) + "\" surface.");
  const Surface& surface = surfaces_[id];
  if (surface.transp > kEpsilon && surface.index <= 0) {
    reporter_->Fatal("Index of refraction must be positive.");
  }
  entry = id + 1;
}

SurfaceId Surfaces::Named(NameId name) {
  SurfaceId& entry = names_[name];
  if (!entry) {
    reporter_->Fatal("Undefined surface \"" + lexer_->text(name) + "\".");
    entry = Blank() + 1;  // each unknown name is reported once
  }
  return entry - 1;
}

SurfaceId Surfaces::CurrentOrDefault() {
  return current() != kNoSurface ? current() : IdOf(DefaultSurface());
}

void Surfaces::SetTranslucency(double amount, const Color& color, double power) {
  building_.translucency = amount;
  building_.translucent = color;
  building_.translucent_pow = power;
}

}  // namespace rayshade
