// The parser's one exit. Calls come in the order of the file; ids are given by the sink, 0, 1, 2 …
// per kind. The parser owns names (variables, surfaces, objects) and scopes; the sink sees ids
// only.
//
//   1. Begin and End of aggregates and definitions nest.
//   2. A primitive that was refused (CheckGeom) is not delivered.
//   3. Nothing may be placed after OnSettings.
#pragma once

#include <cstdint>

#include "rayshade/geom/spec.h"
#include "rayshade/light/spec.h"
#include "rayshade/scene/settings.h"
#include "rayshade/surface/atmosphere.h"
#include "rayshade/surface/surface.h"
#include "rayshade/texture/spec.h"

namespace rayshade {

using DefinitionId = uint32_t;
inline constexpr DefinitionId kNoDefinition = ~DefinitionId{0};

class SceneSink {
 public:
  virtual ~SceneSink() = default;

  virtual SurfaceId AddSurface(const Surface& surface) = 0;
  virtual TextureId AddTexture(const TextureSpec& texture) = 0;
  virtual void AddLight(const LightSpec& light) = 0;  // in file order; area lights cell by cell
  virtual void SetAtmosphere(const Atmosphere& atmosphere) = 0;

  // One object in the innermost open aggregate (or the world, or the open definition).
  virtual void AddPrimitive(GeomSpec&& spec, Attributes&& attributes) = 0;
  virtual void AddInstance(DefinitionId definition, Attributes&& attributes) = 0;

  // list, grid, union, intersect, difference. counts: of a grid. The attributes are known at the
  // end only.
  virtual void BeginAggregate(AggregateKind kind, const int counts[3]) = 0;
  // Returns false where the aggregate was dropped, being empty or CSG of other than two objects
  // (the parser warns).
  virtual bool EndAggregate(Attributes&& attributes) = 0;

  // name NAME <one object>. EndDefinition returns kNoDefinition where the object was dropped.
  virtual void BeginDefinition() = 0;
  virtual DefinitionId EndDefinition() = 0;

  // Once, after the last item of a file without errors.
  virtual void OnSettings(const Settings& settings) = 0;
};

}  // namespace rayshade
