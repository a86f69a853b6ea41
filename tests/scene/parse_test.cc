// What a scene file says, item by item [rayshade4/1 s.3, 4].
#include "rayshade/scene/parse.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

using Calls = std::vector<std::string>;

// A good text, without messages.
RecordingSink Good(const std::string& text, const Options& options = {}) {
  Reading r = ReadText(text, options);
  EXPECT_TRUE(r.good) << text;
  EXPECT_EQ(r.messages, "") << text;
  return std::move(r.sink);
}

// The surface that the last object shows, from itself outwards; the default surface's ambient is
// .1.
Color LastAmbient(const std::string& text) {
  const std::string colors = "surface A ambient 1 0 0 surface B ambient 0 1 0 ";
  const RecordingSink sink = Good(colors + text);
  const SurfaceId id = sink.attributes.back().surface;
  return id == kNoSurface ? DefaultSurface().ambient : sink.surfaces[id].ambient;
}

constexpr Color kRed{1, 0, 0}, kGreen{0, 1, 0}, kDefault{.1, .1, .1};

TEST(Parse, EveryPrimitiveArrivesAsItWasWritten) {
  const RecordingSink sink = Good(
      "plane 0 0 1 0 0 2 disc 2 1 2 3 0 1 0 sphere 2 1 2 3 box 1 2 3 4 5 6 cylinder .5 0 0 0 0 0 1 "
      "cone 1 0 0 0 .5 0 0 3 torus 3 1 0 0 0 0 0 1 triangle 0 0 0 1 0 0 0 1 0 "
      "triangle 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 "
      "triangleuv 0 0 0 0 0 1 .1 .2 1 0 0 0 0 1 .3 .4 0 1 0 0 0 1 .5 .6 "
      "poly 0 0 0 1 0 0 1 1 0 0 1 0 polygon 0 0 0 1 0 0 0 1 0 blob .2 1 2 3 4 5 6 7 8 9 10");
  EXPECT_EQ(sink.calls, (Calls{"plane", "disc", "sphere", "box", "cylinder", "cone", "torus",
                               "triangle", "phong", "trianglev", "poly", "poly", "blob"}));
  EXPECT_EQ(std::get<PlaneSpec>(sink.geoms[0]).normal, (Vector{0, 0, 2}));
  EXPECT_EQ(std::get<ConeSpec>(sink.geoms[5]).top_radius, .5);
  EXPECT_EQ(std::get<PhongTriangleSpec>(sink.geoms[8]).point[2], (Vector{0, 1, 0}));
  EXPECT_EQ(std::get<TriangleUvSpec>(sink.geoms[9]).uv[2][1], .6);
  EXPECT_EQ(std::get<PolygonSpec>(sink.geoms[10]).points.size(), 4u);
  const BlobSpec& blob = std::get<BlobSpec>(sink.geoms[12]);
  ASSERT_EQ(blob.balls.size(), 2u);
  EXPECT_EQ(blob.balls[1].strength, 6);
  EXPECT_EQ(blob.balls[1].center, (Vector{8, 9, 10}));
}

TEST(Parse, AggregatesNestAndKeepWhatIsWrittenAroundThem) {
  const RecordingSink sink = Good(
      "surface A ambient 1 0 0 name thing list sphere 1 0 0 0 end grid 2 3.9 4 object thing "
      "union sphere 1 0 0 0 box 0 0 0 1 1 1 end scale 2 2 2 texture wood end translate 1 0 0 "
      "object A thing");
  EXPECT_EQ(sink.calls, (Calls{"name", "list", "sphere", "end", "named 0", "grid 2 3 4", "object 0",
                               "union", "sphere", "box", "end x1 t0", "end x1", "object 0 s0"}));
}

TEST(Parse, SurfacesAreBoundAsInTheTableOfTheSpecification) {  // [rayshade4/1 s.14.5]
  EXPECT_EQ(LastAmbient("sphere 2 0 0 0"), kDefault);
  EXPECT_EQ(LastAmbient("surface E sphere E 2 0 0 0"), (Color{0, 0, 0}));
  EXPECT_EQ(LastAmbient("applysurf A sphere 2 0 0 0"), kRed);
  EXPECT_EQ(LastAmbient("sphere 2 0 0 0 applysurf A"), kDefault);
  EXPECT_EQ(LastAmbient("applysurf A list applysurf B sphere 2 0 0 0 end"), kGreen);
  EXPECT_EQ(LastAmbient("applysurf A list sphere cursurf 2 0 0 0 end"), kDefault);
  EXPECT_EQ(LastAmbient("applysurf A sphere cursurf ambient 0 .5 0 2 0 0 0"), (Color{0, .5, 0}));
  EXPECT_EQ(LastAmbient("list applysurf A sphere 1 0 0 0 end sphere 2 0 0 0"), kDefault);
  EXPECT_EQ(LastAmbient("surface C A ambient 0 1 0 sphere C 1 0 0 0"), kGreen);
  EXPECT_EQ(LastAmbient("surface C A diffuse 1 1 1 sphere C 1 0 0 0"), kRed);
}

TEST(Parse, AnAggregateTakesTheCurrentSurfaceAtItsEnd) {
  EXPECT_EQ(Good("applysurf ambient 1 0 0 list sphere 1 0 0 0 end").calls,
            (Calls{"list", "sphere", "end s0"}));
  EXPECT_EQ(Good("list sphere 1 0 0 0 end applysurf ambient 1 0 0").calls,
            (Calls{"list", "sphere", "end"}));
  EXPECT_EQ(
      Good("applysurf ambient 1 0 0 name X sphere 1 0 0 0 applysurf ambient 0 1 0 object X").calls,
      (Calls{"name", "sphere s0", "named 0", "object 0 s1"}));
}

TEST(Parse, RedefinedSurfacesLeaveEarlierUsesAlone) {
  const Reading r =
      ReadText("surface A ambient 1 0 0 sphere A 1 0 0 0 surface A ambient 0 1 0 sphere A 1 0 0 0");
  EXPECT_EQ(r.messages, "rs: Warning: stdin, line 1: Redefinition of \"A\" surface.\n");
  EXPECT_EQ(r.sink.calls, (Calls{"sphere s0", "sphere s1"}));
}

TEST(Parse, AnonymousSurfacesStartBlankAndEqualOnesAreOne) {
  const RecordingSink sink = Good(
      "sphere diffuse .1 .2 .3 1 0 0 0 sphere diffuse .1 .2 .3 1 0 0 0 "
      "box translu .5 1 2 3 4 transparent .3 reflective .2 index 1.5 body 0 0 0 extinct .9 specpow "
      "3 "
      "noshadow specular 1 1 1 0 0 0 1 1 1");
  ASSERT_EQ(sink.surfaces.size(), 2u);
  Surface blank;
  blank.diffuse = {.1, .2, .3};
  EXPECT_EQ(sink.surfaces[0], blank);
  EXPECT_EQ(sink.surfaces[1].translucent, (Color{1, 2, 3}));
  EXPECT_EQ(sink.surfaces[1].translucent_pow, 4);
  EXPECT_TRUE(sink.surfaces[1].noshadow);
}

TEST(Parse, NamedTransparentSurfacesNeedAPositiveIndex) {
  EXPECT_EQ(ReadText("surface A transp .5 index 0 sphere A 1 0 0 0").status, 2);
  EXPECT_EQ(ReadText("sphere transp .5 index 0 1 0 0 0").status, 0);
}

TEST(Parse, ObjectNamesTakeTheNewestDefinition) {
  EXPECT_EQ(Good("name Y sphere 1 0 0 0 name Y sphere 2 0 0 0 object Y").calls.back(), "object 1");
  EXPECT_EQ(Good("name Y sphere 1 0 0 0 name X object Y scale 2 2 2 object X").calls,
            (Calls{"name", "sphere", "named 0", "name", "object 0 x1", "named 1", "object 1"}));
}

TEST(Parse, ADroppedObjectDefinesNothing) {
  const Reading r = ReadText("name X sphere 0 0 0 0\nobject X");
  EXPECT_EQ(r.messages,
            "rs: Warning: stdin, line 1: Degenerate sphere.\n"
            "rs: Fatal error: stdin, line 2: There is no object named \"X\".\n");
}

TEST(Parse, ViewAndSettingsMayStandAnywhere) {
  const Settings s = Good(
                         "eyep 1 2 3 scale 1 2 3 translate (time) 0 0 sphere 1 0 0 0 lookp 4 5 6 "
                         "up 0 1 0 fov 30 20 fov 60 "
                         "resolution 64 48 window 0 1 2 3 window 4 5 6 7 crop 0 .5 .1 1 aperture "
                         ".1 focaldist 7 eyesep .2 "
                         "shutter .5 framelength .25 starttime 2 frames 3 sample 4 nojitter filter "
                         "gauss 2 contrast 1 2 3 "
                         "cutoff .1 maxdepth 9 background .1 .2 .3 shadowtransp light .5 ambient "
                         "outfile ../pictures/a.b-1 report verbose quiet 3 log.txt report 5 other")
                         .settings.at(0);
  EXPECT_EQ(s.eye, (Vector{1, 2, 3}));
  EXPECT_EQ(s.hfov, 60);
  EXPECT_FALSE(s.vfov);  // fov with one number forgets the second of an earlier one
  EXPECT_EQ(s.window->xmax, 1);
  EXPECT_EQ(s.focal_distance, 7);
  EXPECT_EQ(s.shutter, .5);
  EXPECT_EQ(s.frames, 3);
  EXPECT_EQ(s.samples, 4);
  EXPECT_FALSE(s.jitter);
  EXPECT_EQ(s.filter_width_used(), 2);
  EXPECT_EQ(s.cutoff, (Color{.1, .1, .1}));
  EXPECT_FALSE(s.shadow_transparency);
  EXPECT_EQ(s.ambient_light, (Color{.5, .5, .5}));
  EXPECT_EQ(s.output, "../pictures/a.b-1");
  EXPECT_TRUE(s.verbose && s.quiet);
  EXPECT_EQ(s.report_frequency, 5);
  EXPECT_EQ(s.report_file, "log.txt");
}

TEST(Parse, CellsOfAnAreaLightAreInOrderAlongACurve) {
  const RecordingSink sink =
      Good("light 1 area 0 0 0 1 0 0 1 0 1 0 1 light 1 area 0 0 0 4 0 0 4 0 2 0 2 sphere 1 0 0 0");
  ASSERT_EQ(sink.lights.size(), 9u);
  EXPECT_EQ(std::get<AreaCellSpec>(sink.lights[0].source).area, 0u);
  const uint32_t expected[] = {0, 1, 4, 5, 2, 3, 6, 7};
  for (int i = 0; i < 8; ++i) {
    const AreaCellSpec& cell = std::get<AreaCellSpec>(sink.lights[1 + i].source);
    EXPECT_EQ(cell.area, 1u);
    EXPECT_EQ(cell.order, expected[i]);
    EXPECT_EQ(cell.cells, 8u);
  }
}

TEST(Parse, LightsComeInFileOrderAndAreasCellByCell) {
  const RecordingSink sink = Good(
      "light 1 point 1 2 3 light .1 .2 .3 directional 0 0 2 noshadow light 6 area 0 0 0 2 0 0 2 0 "
      "3 0 3 "
      "light 1 spot 0 0 1 0 0 0 3 light 1 spot 0 0 1 0 0 0 3 10 20 light 1 extended 2 0 0 9 "
      "sphere 1 0 0 0");
  ASSERT_EQ(sink.lights.size(), 11u);
  EXPECT_TRUE(sink.lights[1].noshadow);
  EXPECT_EQ(sink.lights[2].intensity, (Color{1, 1, 1}));
  EXPECT_EQ(std::get<AreaCellSpec>(sink.lights[3].source).corner, (Vector{1, 0, 0}));
  EXPECT_EQ(std::get<AreaCellSpec>(sink.lights[4].source).corner, (Vector{0, 1, 0}));
  EXPECT_EQ(std::get<AreaCellSpec>(sink.lights[4].source).v, (Vector{0, 1, 0}));
  EXPECT_EQ(std::get<AreaCellSpec>(sink.lights[3].source).cells, 6u);
  EXPECT_EQ(std::get<SpotLightSpec>(sink.lights[8].source).outer, 0);
  EXPECT_EQ(std::get<SpotLightSpec>(sink.lights[9].source).outer, 20);
  EXPECT_EQ(std::get<ExtendedLightSpec>(sink.lights[10].source).radius, 2);
}

TEST(Parse, LightsThatCannotShineAreErrors) {
  for (const char* light : {"directional 0 0 0", "spot 0 0 0 0 0 0 1", "spot 0 0 0 1 0 0 1 20 10",
                            "area 0 0 0 1 0 0 0 0 1 0 2", "area 0 0 0 0 0 0 2 0 1 0 2"}) {
    EXPECT_EQ(ReadText(std::string("light 1 ") + light + " sphere 1 0 0 0").status, 1) << light;
  }
  EXPECT_EQ(ReadText("light 1 2 point 0 0 0 sphere 1 0 0 0").status,
            1);  // two numbers: a syntax error
}

TEST(Parse, AnAtmosphereReplacesTheEffectsOfTheOneBefore) {
  const RecordingSink sink = Good(
      "atmosphere 2.9 fog 1 0 0 1 1 1 mist 0 0 1 2 2 2 0 1 atmosphere sphere 1 0 0 0 "
      "atmosphere fogdeck 1 2 3 4 5 6 7.5 .1 .2 .3 9 9 9");
  ASSERT_EQ(sink.atmospheres.size(), 3u);
  EXPECT_EQ(sink.atmospheres[0].effects.size(), 2u);
  EXPECT_TRUE(sink.atmospheres[1].effects.empty());
  EXPECT_EQ(sink.atmospheres[2].index, 2);
  EXPECT_EQ(std::get<FogDeck>(sink.atmospheres[2].effects[0]).octaves, 7);
  EXPECT_EQ(ReadText("atmosphere .5 sphere 1 0 0 0").status, 2);
}

TEST(Parse, OctavesThatNeverEndAreLimitedWithAWarning) {
  const auto expect = [](const std::string& texture, bool warned) {
    const Reading r = ReadText("sphere 1 0 0 0 texture " + texture);
    EXPECT_EQ(r.messages,
              warned ? "rs: Warning: stdin, line 1: Too many octaves; 4096 are computed.\n" : "");
  };
  expect("sky 1 .5 2 1e9 .4 .3", false);
  expect("sky 1 -.5 2 1e9 .4 .3", true);
  expect("fbm 0 1 -.5 2 4096 .1", false);
  expect("fbm 0 1 -.5 2 4097 .1", true);
  expect("fbmbump 0 1 3 1 1e9", true);
  expect("cloud 1 -.5 2 1e9 .4 .3 1", true);
  expect("windy 1 .7 2 .6 1e9 2.2 1 .4", true);
  expect("windy 1 .7 2 .6 1e9 2.2 .6 .4", false);
}

TEST(Parse, TransformsAfterATextureAreTheTextures) {
  const RecordingSink sink = Good(
      "sphere 1 0 0 0 translate 1 0 0 rotate 0 0 1 90 texture checker diffuse 1 1 1 scale 2 2 2 "
      "texture fbm 1 2 3 4 5.5 6 texture stripe diffuse 1 1 1 .1 .2 map planar 0 0 0 0 0 1 1 0 0");
  EXPECT_EQ(sink.calls, (Calls{"sphere x1 t0 t1 t2"}));
  EXPECT_EQ(sink.textures[0].transforms.size(), 1u);
  EXPECT_EQ(std::get<FbmSpec>(sink.textures[1].kind).octaves, 5);
  const MappingSpec mapping = std::get<StripeSpec>(sink.textures[2].kind).mapping;
  EXPECT_EQ(mapping.kind, MappingKind::kPlanar);
  EXPECT_TRUE(mapping.framed);
  EXPECT_EQ(mapping.u_axis, (Vector{1, 0, 0}));
}

TEST(Parse, EveryTextureIsRead) {
  const RecordingSink sink = Good(
      "sphere 1 0 0 0 texture blotch .5 diffuse 1 1 1 texture bump .3 texture gloss .8 texture "
      "wood "
      "texture marble texture fbmbump 1 2 3 4 5 texture cloud 1 2 3 4 5 6 7 texture sky 1 2 3 4 5 "
      "6 "
      "texture windy 1 2 3 4 5 6 7 8 texture stripe diffuse 1 0 0 .1 .2");
  EXPECT_EQ(sink.textures.size(), 10u);
  EXPECT_EQ(std::get<CloudSpec>(sink.textures[6].kind).transcale, 7);
  EXPECT_EQ(std::get<WindySpec>(sink.textures[8].kind).offset, 8);
}

TEST(Parse, OptionFMarksTrianglesAndPolygons) {
  Options flip;
  flip.flip_normals = true;
  const RecordingSink sink =
      Good("triangle 0 0 0 1 0 0 0 1 0 poly 0 0 0 1 0 0 0 1 0 sphere 1 0 0 0", flip);
  EXPECT_TRUE(std::get<TriangleSpec>(sink.geoms[0]).flip);
  EXPECT_TRUE(std::get<PolygonSpec>(sink.geoms[1]).flip);
}

TEST(Parse, SizesMayBeUsedToTheBrim) {  // deep nesting is the user's affair
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "list ";
  text += "sphere 1 0 0 0 ";
  for (int i = 0; i < 2000; ++i) text += "end ";
  EXPECT_EQ(Good(text).calls.size(), 4001u);
}

}  // namespace
}  // namespace rayshade
