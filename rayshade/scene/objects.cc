// Objects on their way to the sink; see objects.h.
#include "rayshade/scene/objects.h"

#include <cinttypes>
#include <cstdio>
#include <utility>

#include "rayshade/geom/kind_name.h"
#include "rayshade/geom/make_geom.h"
#include "rayshade/scene/symbols.h"
#include "rayshade/texture/noise.h"

namespace rayshade {
namespace {

// May the primitive be a CSG operand without advice [rayshade4/2 s.5]?
bool IsClosed(const GeomSpec& spec) {
  return std::holds_alternative<SphereSpec>(spec) || std::holds_alternative<BoxSpec>(spec) ||
         std::holds_alternative<TorusSpec>(spec) || std::holds_alternative<BlobSpec>(spec);
}

std::string_view KindName(AggregateKind kind) {
  return IsCsg(kind) ? "csg" : kind == AggregateKind::kGrid ? "grid" : "list";
}

}  // namespace

Objects::Objects(const Lexer* lexer, GatedSink* sink, Reporter* reporter, Surfaces* surfaces,
                 DataFiles* files, bool flip_normals)
    : lexer_(lexer),
      sink_(sink),
      reporter_(reporter),
      surfaces_(surfaces),
      files_(files),
      flip_normals_(flip_normals) {}

void Objects::Start(Making making, SurfaceId surface) {
  making_ = making;
  attributes_.surface = surface;
  attributes_.transforms = {};
  attributes_.textures.clear();
  transforms_ = &attributes_.transforms;
}

// ---- shapes ----

void Objects::Set(SurfaceId surface, GeomSpec&& spec) {
  geom_ = std::move(spec);
  Start(Making::kPrimitive, surface);
  primitives_ = 1;
  contents_ = kKindNames[geom_.index()];
  const std::optional<Complaint> complaint = CheckGeom(geom_);
  if (!complaint) return;
  reporter_->Report(complaint->severity, complaint->text);
  if (!complaint->dropped) return;
  making_ = complaint->severity >= Severity::kError ? Making::kWrong : Making::kNothing;
}

void Objects::SetTriangle(SurfaceId surface, const std::array<Vector, 3>& points) {
  TriangleSpec spec;
  for (int i = 0; i < 3; ++i) spec.point[i] = points[i];
  spec.flip = flip_normals_;
  Set(surface, std::move(spec));
}

void Objects::SetPhongTriangle(SurfaceId surface, const std::array<Vector, 3>& points,
                               const std::array<Vector, 3>& normals) {
  PhongTriangleSpec spec;
  for (int i = 0; i < 3; ++i) {
    spec.point[i] = points[i];
    spec.normal[i] = normals[i];
  }
  spec.flip = flip_normals_;
  Set(surface, std::move(spec));
}

void Objects::SetTriangleUv(SurfaceId surface, const std::array<Vector, 3>& points,
                            const std::array<Vector, 3>& normals, const std::array<double, 6>& uv) {
  TriangleUvSpec spec;
  for (int i = 0; i < 3; ++i) {
    spec.point[i] = points[i];
    spec.normal[i] = normals[i];
    spec.uv[i][0] = uv[2 * i];
    spec.uv[i][1] = uv[2 * i + 1];
  }
  spec.flip = flip_normals_;
  Set(surface, std::move(spec));
}

void Objects::SetPolygon(SurfaceId surface) {
  PolygonSpec spec{points_, flip_normals_};
  points_.clear();
  Set(surface, std::move(spec));
}

void Objects::SetBlob(SurfaceId surface, double threshold) {
  BlobSpec spec{threshold, balls_};
  balls_.clear();
  Set(surface, std::move(spec));
}

void Objects::SetHeightfield(SurfaceId surface, NameId file) {
  try {
    Set(surface, files_->ReadHeightfield(lexer_->text(file)));
  } catch (const DataFileError& error) {
    reporter_->Report(error.severity, error.what());
    Start(Making::kWrong, surface);
  }
}

void Objects::SetInstance(SurfaceId surface, NameId name) {
  DefinitionId& entry = definitions_[name];
  if (!entry) {
    reporter_->Fatal("There is no object named \"" + lexer_->text(name) + "\".");
    entry = 1;  // each unknown name is reported once
  }
  instance_ = entry - 1;
  Start(Making::kInstance, surface);
  primitives_ = primitives_in_[name];
  contents_ = "instance";
}

// ---- aggregates ----

void Objects::Open(AggregateKind kind, const std::array<int, 3>& counts, bool dropped) {
  dropped = dropped || scopes_.back().dropped;
  if (!dropped) sink_->BeginAggregate(kind, counts.data());
  Scope scope;
  scope.kind = kind;
  scope.dropped = dropped;
  scopes_.push_back(scope);
  surfaces_->PushScope();
}

void Objects::OpenGrid(int x, int y, int z) {
  const bool valid = x >= 1 && y >= 1 && z >= 1;
  if (!valid) reporter_->Warn("Invalid grid specification.");
  Open(AggregateKind::kGrid, {x, y, z}, !valid);
}

void Objects::CloseAggregate() {
  const Scope scope = scopes_.back();
  scopes_.pop_back();
  surfaces_->PopScope();
  Start(CheckMembers(scope), surfaces_->current());
  primitives_ = scope.primitives;
  contents_ = KindName(scope.kind);
}

Objects::Making Objects::CheckMembers(const Scope& scope) {
  if (scope.unsure) return Making::kWrong;
  if (IsCsg(scope.kind) && scope.open_member && !advised_open_) {
    advised_open_ = true;
    reporter_->Report(Severity::kAdvise, "Performing CSG with non-closed object(s).");
  }
  if (scope.members == 0) {
    if (!scope.dropped) reporter_->Warn("Null object defined.");
  } else if (IsCsg(scope.kind) && scope.members != 2) {
    reporter_->Warn(scope.members < 2 ? "CSG needs at least two objects."
                                      : "Currently, CSG only handles two objects.");
  }
  return scope.dropped ? Making::kNothing : Making::kAggregate;
}

// ---- what is written around ----

void Objects::Transform(TransformKind kind, std::initializer_list<NumberValue> arguments) {
  // One that varies is made anew for each moment.
  bool varies = false;
  for (const NumberValue& argument : arguments) varies = varies || argument.expression;
  if (varies) {
    AnimatedTransform animated;
    animated.kind = kind;
    for (const NumberValue& argument : arguments) {
      animated.arguments.push_back(ToExpression(argument));
    }
    return transforms_->Append(std::move(animated));
  }

  double numbers[12] = {};
  size_t count = 0;
  for (const NumberValue& argument : arguments) numbers[count++] = argument.number;
  if (kind == TransformKind::kRotate &&
      !(Length({numbers[0], numbers[1], numbers[2]}) >= kEpsilon)) {
    reporter_->Warn("Degenerate rotation axis.");
  }
  try {
    transforms_->Append(MakeTransform(kind, numbers));
  } catch (const DegenerateTransform& error) {
    reporter_->Fatal(error.what());
  }
}

void Objects::FitOctaves() {
  const bool cut = std::visit(
      [](auto& texture) {
        if constexpr (requires { texture.hscale; }) {
          return rayshade::FitOctaves(texture.hscale, &texture.octaves);
        } else if constexpr (requires { texture.octaves; }) {
          return rayshade::FitOctaves(OmegaOf(texture.h, texture.lambda), &texture.octaves);
        } else {
          return false;
        }
      },
      texture_.kind);
  if (cut) {
    reporter_->Warn("Too many octaves; " + std::to_string(kOctavesMax) + " are computed.");
  }
}

void Objects::EndTexture() {
  if (making_ == Making::kNothing || scopes_.back().dropped) return;
  attributes_.textures.push_back(sink_->AddTexture(texture_));
}

// ---- placing ----

void Objects::Place() {
  Scope& scope = scopes_.back();
  const Making made = std::exchange(making_, Making::kNothing);
  transforms_ = &ignored_;
  if (made == Making::kNothing) return;
  if (!scope.dropped && made == Making::kPrimitive) {
    scope.open_member = scope.open_member || !IsClosed(geom_);
    sink_->AddPrimitive(std::move(geom_), std::move(attributes_));
  } else if (!scope.dropped && made == Making::kInstance) {
    sink_->AddInstance(instance_, std::move(attributes_));
  } else if (!scope.dropped && made == Making::kAggregate) {
    if (!sink_->EndAggregate(std::move(attributes_))) return;
  }
  ++scope.members;
  scope.primitives += primitives_;
  scope.contents = contents_;
}

void Objects::OpenDefinition() {
  sink_->BeginDefinition();
  Scope scope;
  scope.definition = true;
  scopes_.push_back(scope);
}

void Objects::CloseDefinition(NameId name) {
  const Scope scope = scopes_.back();
  scopes_.pop_back();
  const DefinitionId definition = sink_->EndDefinition();
  if (scope.members == 0 || definition == kNoDefinition) return;
  definitions_[name] = definition + 1;
  primitives_in_[name] = scope.primitives;
  if (reporter_->log()) Tell(name, scope);
}

// The original has not computed the object's box here, and tells of none.
void Objects::Tell(NameId name, const Scope& definition) const {
  std::fprintf(reporter_->log(), "%.*s \"%s\":\n\t%" PRIu64 " primitive%s\n",
               static_cast<int>(definition.contents.size()), definition.contents.data(),
               lexer_->text(name).c_str(), definition.primitives,
               definition.primitives == 1 ? " " : "s");
}

void Objects::Abandon() {
  while (scopes_.back().definition) scopes_.pop_back();
  scopes_.back().unsure = true;
  making_ = Making::kNothing;
  transforms_ = &ignored_;
  points_.clear();
  balls_.clear();
}

}  // namespace rayshade
