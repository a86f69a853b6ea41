// Named, current and anonymous surfaces, and their scopes [rayshade4/1 s.4].
#pragma once

#include <unordered_map>
#include <vector>

#include "rayshade/scene/gated_sink.h"
#include "rayshade/scene/parser_value.h"
#include "rayshade/surface/surface.h"

namespace rayshade {

class Surfaces {
 public:
  Surfaces(const Lexer* lexer, GatedSink* sink, Reporter* reporter)
      : lexer_(lexer), sink_(sink), reporter_(reporter) {}

  // Surfaces never change, so that a copy is the surface itself under one more name.
  void Define(NameId name, SurfaceId surface);
  SurfaceId Named(NameId name);
  SurfaceId Blank() { return IdOf(Surface()); }

  // The current surface of the innermost aggregate; kNoSurface where applysurf set none.
  SurfaceId current() const { return cells_.back(); }
  SurfaceId CurrentOrDefault();  // cursurf
  void Apply(SurfaceId surface) { cells_.back() = surface; }
  void PushScope() { cells_.push_back(kNoSurface); }
  void PopScope() { cells_.pop_back(); }

  // A list of attributes, from Start to Finish; lists do not nest.
  void StartBlank() { building_ = Surface(); }
  void StartFrom(SurfaceId surface) { building_ = surfaces_[surface]; }
  Surface& building() { return building_; }
  void SetTranslucency(double amount, const Color& color, double power);
  SurfaceId Finish() { return IdOf(building_); }

 private:
  struct Hash {
    size_t operator()(const Surface& surface) const;
  };
  // Equal surfaces are one.
  SurfaceId IdOf(const Surface& surface);

  const Lexer* lexer_;
  GatedSink* sink_;
  Reporter* reporter_;
  NameMap<SurfaceId> names_;       // number + 1, 0: not defined
  std::vector<Surface> surfaces_;  // by id
  std::unordered_map<Surface, SurfaceId, Hash> ids_;
  std::vector<SurfaceId> cells_{kNoSurface};
  Surface building_;
};

}  // namespace rayshade
