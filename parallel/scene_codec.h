// Field lists of the core's types, for messages and the spool (wire.h). What a type holds that is
// derived (the shade of a Placement's Finish) does not travel.
#pragma once

#include <memory>

#include "parallel/wire.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/common/ray.h"
#include "rayshade/render/camera.h"
#include "rayshade/scene/scene.h"
#include "rayshade/shade/crossing.h"

namespace rayshade {

// clang-format off
template <class A> void Fields(A& a, Vector& v) { a("x", v.x); a("y", v.y); a("z", v.z); }
template <class A> void Fields(A& a, Color& c) { a("r", c.r); a("g", c.g); a("b", c.b); }
template <class A> void Fields(A& a, Bounds& b) { a("low", b.low); a("high", b.high); }
template <class A> void Fields(A& a, Matrix& m) { a("m", m.m[0]); a("m", m.m[1]); a("m", m.m[2]); }
template <class A> void Fields(A& a, Transform& t) {
  a("matrix", t.matrix); a("translation", t.translation);
  a("inverse_matrix", t.inverse_matrix); a("inverse_translation", t.inverse_translation);
}
template <class A> void Fields(A& a, ExpressionStep& s) { a("op", s.op); a("number", s.number); }
template <class A> void Fields(A& a, Expression& e) {
  if constexpr (A::kReading) {
    std::vector<ExpressionStep> steps;
    a("steps", steps);
    e = Expression(std::move(steps));
  } else {
    auto steps = e.steps();
    a("steps", steps);
  }
}
template <class A> void Fields(A& a, AnimatedTransform& t) { a("kind", t.kind); a("arguments", t.arguments); }
template <class A> void Fields(A& a, TransformChain& c) {
  if constexpr (A::kReading) {
    std::vector<TransformLink> links;
    a("links", links);
    c = TransformChain();
    for (TransformLink& link : links) {
      // Links were folded when they were written: they are restored one by one.
      std::visit([&c](auto& l) { c.Restore(std::move(l)); }, link);
    }
  } else {
    auto links = c.links();
    a("links", links);
  }
}
template <class A> void Fields(A& a, Attributes& t) {
  a("surface", t.surface); a("transforms", t.transforms); a("textures", t.textures);
}
template <class A> void Fields(A& a, SphereSpec& s) { a("radius", s.radius); a("center", s.center); }
template <class A> void Fields(A& a, BoxSpec& s) { a("corner", s.corner); a("opposite", s.opposite); }
template <class A> void Fields(A& a, PlaneSpec& s) { a("point", s.point); a("normal", s.normal); }
template <class A> void Fields(A& a, DiscSpec& s) { a("radius", s.radius); a("center", s.center); a("normal", s.normal); }
template <class A> void Fields(A& a, TriangleSpec& s) { a("point", s.point); a("flip", s.flip); }
template <class A> void Fields(A& a, PhongTriangleSpec& s) { a("point", s.point); a("normal", s.normal); a("flip", s.flip); }
template <class A> void Fields(A& a, TriangleUvSpec& s) {
  a("point", s.point); a("normal", s.normal); a("uv", s.uv[0]); a("uv", s.uv[1]); a("uv", s.uv[2]); a("flip", s.flip);
}
template <class A> void Fields(A& a, PolygonSpec& s) { a("points", s.points); a("flip", s.flip); }
template <class A> void Fields(A& a, CylinderSpec& s) { a("radius", s.radius); a("base", s.base); a("top", s.top); }
template <class A> void Fields(A& a, ConeSpec& s) {
  a("base_radius", s.base_radius); a("base", s.base); a("top_radius", s.top_radius); a("top", s.top);
}
template <class A> void Fields(A& a, TorusSpec& s) {
  a("swept_radius", s.swept_radius); a("tube_radius", s.tube_radius); a("center", s.center); a("normal", s.normal);
}
template <class A> void Fields(A& a, BlobSpec::Ball& b) { a("strength", b.strength); a("radius", b.radius); a("center", b.center); }
template <class A> void Fields(A& a, BlobSpec& s) { a("threshold", s.threshold); a("balls", s.balls); }
template <class A> void Fields(A& a, HeightfieldSpec& s) { a("file", s.file); a("size", s.size); a("altitudes", s.altitudes); }
template <class A> void Fields(A& a, CompositeSpec& s) { a("kind", s.kind); a("counts", s.counts); a("members", s.members); }
template <class A> void Fields(A& a, PlacedSpec& s) { a("geom", s.geom); a("attributes", s.attributes); }
template <class A> void Fields(A& a, PathLevel& l) { a("attributes", l.attributes); a("clip", l.clip); }
template <class A> void Fields(A& a, Placement& p) {
  a("levels", p.levels);
  if constexpr (A::kReading) {
    if (p.levels.empty()) throw parallel::WireError("a placement without levels");
    p.Finish();
  }
}
template <class A> void Fields(A& a, Surface& s) {
  a("ambient", s.ambient); a("diffuse", s.diffuse); a("specular", s.specular); a("specpow", s.specpow); a("body", s.body);
  a("extinct", s.extinct); a("transp", s.transp); a("reflect", s.reflect); a("index", s.index);
  a("translucency", s.translucency); a("translucent", s.translucent); a("translucent_pow", s.translucent_pow);
  a("noshadow", s.noshadow);
}
template <class A> void Fields(A& a, Fog& f) { a("color", f.color); a("half_distance", f.half_distance); }
template <class A> void Fields(A& a, Mist& m) {
  a("color", m.color); a("half_distance", m.half_distance); a("zero", m.zero); a("scale", m.scale);
}
template <class A> void Fields(A& a, FogDeck& f) {
  a("altitude", f.altitude); a("offset", f.offset); a("scale", f.scale); a("chaos_scale", f.chaos_scale);
  a("octaves", f.octaves); a("color", f.color); a("half_distance", f.half_distance);
}
template <class A> void Fields(A& a, Atmosphere& s) { a("index", s.index); a("effects", s.effects); }
template <class A> void Fields(A& a, PointLightSpec& l) { a("position", l.position); }
template <class A> void Fields(A& a, DirectionalLightSpec& l) { a("direction", l.direction); }
template <class A> void Fields(A& a, SpotLightSpec& l) {
  a("from", l.from); a("at", l.at); a("exponent", l.exponent); a("inner", l.inner); a("outer", l.outer);
}
template <class A> void Fields(A& a, ExtendedLightSpec& l) { a("radius", l.radius); a("position", l.position); }
template <class A> void Fields(A& a, AreaCellSpec& l) {
  a("corner", l.corner); a("u", l.u); a("v", l.v); a("area", l.area); a("order", l.order); a("cells", l.cells);
}
template <class A> void Fields(A& a, LightSpec& l) { a("intensity", l.intensity); a("noshadow", l.noshadow); a("source", l.source); }
template <class A> void Fields(A& a, ImageData& i) {
  a("file", i.file); a("width", i.width); a("height", i.height); a("channels", i.channels); a("color", i.color); a("alpha", i.alpha);
  if constexpr (A::kReading) {
    const bool sized = i.width > 0 && i.height > 0 && (i.channels == 1 || i.channels == 3);
    const uint64_t pixels = sized ? static_cast<uint64_t>(i.width) * static_cast<uint64_t>(i.height) : 0;
    if (!sized || i.color.size() / static_cast<uint64_t>(i.channels) != pixels || i.color.size() % pixels != 0 ||
        (!i.alpha.empty() && i.alpha.size() != pixels)) {
      throw parallel::WireError("an image of another size than its pixels");
    }
  }
}
template <class A> void Fields(A& a, MappingSpec& m) {
  a("kind", m.kind); a("framed", m.framed); a("origin", m.origin); a("up", m.up); a("u_axis", m.u_axis);
}
template <class A> void Fields(A& a, CheckerSpec& t) { a("surface", t.surface); }
template <class A> void Fields(A& a, BlotchSpec& t) { a("mix", t.mix); a("surface", t.surface); }
template <class A> void Fields(A& a, BumpSpec& t) { a("size", t.size); }
template <class A> void Fields(A& a, GlossSpec& t) { a("gloss", t.gloss); }
template <class A> void Fields(A&, WoodSpec&) {}
template <class A> void Fields(A& a, MarbleSpec& t) { a("map", t.map); }
template <class A> void Fields(A& a, FbmSpec& t) {
  a("offset", t.offset); a("scale", t.scale); a("h", t.h); a("lambda", t.lambda); a("octaves", t.octaves);
  a("threshold", t.threshold); a("map", t.map);
}
template <class A> void Fields(A& a, FbmBumpSpec& t) {
  a("offset", t.offset); a("scale", t.scale); a("h", t.h); a("lambda", t.lambda); a("octaves", t.octaves);
}
template <class A> void Fields(A& a, CloudSpec& t) {
  a("scale", t.scale); a("h", t.h); a("lambda", t.lambda); a("octaves", t.octaves); a("cthresh", t.cthresh);
  a("lthresh", t.lthresh); a("transcale", t.transcale);
}
template <class A> void Fields(A& a, SkySpec& t) {
  a("scale", t.scale); a("h", t.h); a("lambda", t.lambda); a("octaves", t.octaves); a("cthresh", t.cthresh); a("lthresh", t.lthresh);
}
template <class A> void Fields(A& a, StripeSpec& t) {
  a("surface", t.surface); a("width", t.width); a("bump", t.bump); a("mapping", t.mapping);
}
template <class A> void Fields(A& a, WindySpec& t) {
  a("scale", t.scale); a("wave_scale", t.wave_scale); a("chop_scale", t.chop_scale); a("bump_scale", t.bump_scale);
  a("octaves", t.octaves); a("tscale", t.tscale); a("hscale", t.hscale); a("offset", t.offset);
}
template <class A> void Fields(A& a, MountSpec& t) { a("map", t.map); a("turbulence", t.turbulence); a("slope", t.slope); }
// The image itself travels with the objects that show it.
template <class A> void Fields(A& a, ImageSpec& t) {
  a("component", t.component); a("range_low", t.range_low); a("range_high", t.range_high);
  a("smooth", t.smooth); a("surface", t.surface); a("tile_u", t.tile_u); a("tile_v", t.tile_v); a("mapping", t.mapping);
}
template <class A> void Fields(A& a, TextureSpec& t) { a("kind", t.kind); a("transforms", t.transforms); }
template <class A> void Fields(A& a, Window& w) { a("xmin", w.xmin); a("xmax", w.xmax); a("ymin", w.ymin); a("ymax", w.ymax); }
template <class A> void Fields(A& a, Crop& c) { a("left", c.left); a("right", c.right); a("low", c.low); a("high", c.high); }
// Of the settings, what tracing and shading need; output and reports are the host's.
template <class A> void Fields(A& a, Settings& s) {
  a("eye", s.eye); a("look", s.look); a("up", s.up); a("hfov", s.hfov); a("vfov", s.vfov); a("width", s.width);
  a("height", s.height); a("window", s.window); a("crop", s.crop); a("aperture", s.aperture);
  a("focal_distance", s.focal_distance); a("eye_separation", s.eye_separation); a("stereo", s.stereo);
  a("start_time", s.start_time); a("frame_length", s.frame_length); a("shutter", s.shutter); a("samples", s.samples);
  a("jitter", s.jitter); a("filter", s.filter); a("filter_width", s.filter_width); a("contrast", s.contrast);
  a("seed", s.seed); a("max_depth", s.max_depth); a("cutoff", s.cutoff); a("background", s.background);
  a("ambient_light", s.ambient_light); a("shadows", s.shadows); a("shadow_transparency", s.shadow_transparency);
  a("pattern", s.pattern); a("every_pixel_full", s.every_pixel_full); a("area_cells", s.area_cells);
  a("light_cutoff", s.light_cutoff);
}
// Placements travel with the objects that stand by them.
template <class A> void Fields(A& a, SceneSpec& s) {
  a("settings", s.settings); a("surfaces", s.surfaces); a("textures", s.textures); a("lights", s.lights);
  a("atmosphere", s.atmosphere);
}
template <class A> void Fields(A& a, Medium& m) { a("index", m.index); a("extinct", m.extinct); }
// Where its media stand in the bundle is told by their number alone: they follow in order.
template <class A> void Fields(A& a, Ray& r) {
  a("origin", r.origin); a("direction", r.direction); a("min_distance", r.min_distance); a("time", r.time);
  a("contribution", r.contribution); a("key", r.key); a("sample_number", r.sample_number); a("media_count", r.media_count);
  a("depth", r.depth); a("kind", r.kind);
}
template <class A> void Fields(A& a, RayBundle& b) {
  a("rays", b.rays); a("media", b.media);
  if constexpr (A::kReading) {
    size_t at = 0;
    for (Ray& r : b.rays) {
      r.media_begin = static_cast<uint32_t>(at);
      at += r.media_count;
    }
    if (at != b.media.size()) throw parallel::WireError("media that belong to no ray");
  }
}
template <class A> void Fields(A& a, ShadowCrossing& c) {
  a("distance", c.distance); a("rank", c.rank); a("through", c.through); a("extinct", c.extinct);
  a("entering", c.entering); a("opaque", c.opaque);
}
template <class A> void Fields(A& a, OpCounts& c) {
#define RAYSHADE_FIELD(name) a(#name, c.name);
  RAYSHADE_OP_COUNTS(RAYSHADE_FIELD)
#undef RAYSHADE_FIELD
  for (KindCounts& kind : c.kinds) { a("tests", kind.tests); a("hits", kind.hits); }
}
// clang-format on

}  // namespace rayshade
