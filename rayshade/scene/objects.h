// Objects as they are read: shapes with what is written around them, aggregates, definitions
// [rayshade4/1 s.3.2, 4; rayshade4/2 s.8, 9].
//
//   1. At most one object is in the making: what stands inside an aggregate is placed before the
//   aggregate ends.
//   2. An object that was refused is left out; one that was wrong (an error) still counts as a
//   member, so that no other complaint follows from it.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "rayshade/scene/data_files.h"
#include "rayshade/scene/gated_sink.h"
#include "rayshade/scene/parser_value.h"
#include "rayshade/scene/surfaces.h"

namespace rayshade {

class Objects {
 public:
  Objects(const Lexer* lexer, GatedSink* sink, Reporter* reporter, Surfaces* surfaces,
          DataFiles* files, bool flip_normals);

  // The shape of an object.
  void Set(SurfaceId surface, GeomSpec&& spec);
  void SetTriangle(SurfaceId surface, const std::array<Vector, 3>& points);
  void SetPhongTriangle(SurfaceId surface, const std::array<Vector, 3>& points,
                        const std::array<Vector, 3>& normals);
  void SetTriangleUv(SurfaceId surface, const std::array<Vector, 3>& points,
                     const std::array<Vector, 3>& normals, const std::array<double, 6>& uv);
  void AddPoint(const Vector& point) { points_.push_back(point); }
  void SetPolygon(SurfaceId surface);  // of the points added
  void AddBall(double strength, double radius, const Vector& center) {
    balls_.push_back({strength, radius, center});
  }
  void SetBlob(SurfaceId surface, double threshold);  // of the balls added
  void SetHeightfield(SurfaceId surface, NameId file);
  void SetInstance(SurfaceId surface, NameId name);
  void OpenAggregate(AggregateKind kind) { Open(kind, {1, 1, 1}, false); }
  void OpenGrid(int x, int y, int z);
  void CloseAggregate();

  // What is written around it.
  void Transform(TransformKind kind, std::initializer_list<NumberValue> arguments);
  void IgnoreTransforms() { transforms_ = &ignored_; }  // those of eyep
  template <typename Kind>
  void BeginTexture(Kind&& kind) {
    texture_.kind = std::forward<Kind>(kind);
    texture_.transforms = {};
    transforms_ = &texture_.transforms;
    FitOctaves();
  }
  void EndTexture();

  void Place();  // the object is complete
  void OpenDefinition();
  void CloseDefinition(NameId name);
  // After a syntax error: forgets what was begun of the item.
  void Abandon();

  bool anything_placed() const { return scopes_.front().members > 0; }

 private:
  enum class Making { kNothing, kPrimitive, kInstance, kAggregate, kWrong };
  struct Scope {  // the world, an aggregate or a definition
    bool definition = false;
    bool dropped = false;  // its members go nowhere
    bool unsure = false;   // a member was lost to a syntax error
    bool open_member = false;
    AggregateKind kind = AggregateKind::kList;
    int members = 0;
    uint64_t primitives = 0;    // in them
    std::string_view contents;  // what kind of object a definition holds, for the report
  };

  void Open(AggregateKind kind, const std::array<int, 3>& counts, bool dropped);
  void Start(Making making, SurfaceId surface);
  Making CheckMembers(const Scope& scope);
  void Tell(NameId name, const Scope& definition) const;
  void FitOctaves();  // of the texture that has begun

  const Lexer* lexer_;
  GatedSink* sink_;
  Reporter* reporter_;
  Surfaces* surfaces_;
  DataFiles* files_;
  bool flip_normals_;
  bool advised_open_ = false;

  Making making_ = Making::kNothing;
  GeomSpec geom_;
  DefinitionId instance_ = kNoDefinition;
  uint64_t primitives_ = 1;    // of the object in the making
  std::string_view contents_;  // its kind
  Attributes attributes_;
  TextureSpec texture_;
  TransformChain ignored_;
  TransformChain* transforms_ = &ignored_;
  std::vector<Vector> points_;
  std::vector<BlobSpec::Ball> balls_;

  std::vector<Scope> scopes_{1};
  NameMap<DefinitionId> definitions_;  // number + 1, 0: not defined
  NameMap<uint64_t> primitives_in_;    // of definitions
};

}  // namespace rayshade
