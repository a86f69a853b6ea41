// Numbers that nobody means, in every place of a scene: a message, or an ordinary picture; never a
// colour that is no number, or infinite.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "tests/shade/text_scene.h"

namespace rayshade::test {
namespace {

const char kAround[] =
    "light 1 point 5 -10 10\nsphere diffuse .5 .5 .5 reflect .3 specular 1 1 1 1 0 0 0\n"
    "surface w diffuse 1 1 1\n";

const char* const kStatements[] = {
    "sphere 1 .1 .2 .3",
    "box -1 -1.1 -1.2 1 1.1 1.2",
    "plane .1 .2 -1 .1 .2 1",
    "disc 1 .1 .2 .3 .1 -.9 .2",
    "triangle 0 .1 .2 1 .2 .3 .4 .5 1",
    "triangle 0 .1 .2 .1 .1 1 1 .2 .3 .1 -.1 1 .4 .5 1 -.1 .1 1",
    "triangleuv 0 .1 .2 .1 .1 1 .1 .2 1 .2 .3 .1 -.1 1 .9 .1 .4 .5 1 -.1 .1 1 .3 .8",
    "polygon 0 .1 .2 1 .1 .2 1 1 .2 .1 1 .2",
    "cylinder 1 .1 .2 .3 .4 .5 2",
    "cone 1 .1 .2 .3 .4 .4 .5 2",
    "torus 1 .3 .1 .2 .3 .4 .5 1",
    "blob .3 1 1 .1 .2 .3 1.1 .9 .4 .5 .6",
    "light .9 .8 .7 point 1 -2 3",
    "light 1 directional 1 -2 3",
    "light 1 spot 1 -2 3 .1 .2 .3 2 10 20",
    "light 1 extended .5 1 -2 3",
    "light .5 ambient",
    "eyep 1 -10 3",
    "lookp .1 .2 .3",
    "up .1 .2 .9",
    "fov 30 25",
    "aperture .1",
    "background .1 .2 .3",
    "surface q ambient .1 .2 .3 diffuse .4 .5 .6 specular .7 .8 .9 specpow 10 body .3 .2 .1 "
    "extinct .9 transp .5 reflect .4 index 1.3\nsphere q 1.2 0 0 0",
    "atmosphere 1.1 fog .1 .2 .3 4 5 6",
    "sphere 1.2 0 0 0 translate .1 .2 .3",
    "sphere 1.2 0 0 0 scale 1.1 1.2 .9",
    "sphere 1.2 0 0 0 rotate .1 .2 1 30",
    "sphere 1.2 0 0 0 transform 1 .1 0 0 1 .1 .1 0 1 .1 .2 .3",
    "sphere 1.2 0 0 0 texture checker w scale 1.1 1.2 .9",
    "sphere 1.2 0 0 0 texture bump .3 scale .1 .1 .1",
    "sphere 1.2 0 0 0 texture stripe w 1 .3",
    "sphere 1.2 0 0 0 texture blotch .4 w",
    "sphere 1.2 0 0 0 texture gloss .4",
    "sphere 1.2 0 0 0 texture fbm .1 .9 .5 2 6 .1",
    "sphere 1.2 0 0 0 texture fbmbump .1 .9 .5 2 6",
    "sphere 1.2 0 0 0 texture cloud 1 .5 2 6 .4 .3 1",
    "sphere 1.2 0 0 0 texture sky 1 .5 2 6 .4 .3",
    "sphere 1.2 0 0 0 texture windy 1 .7 2 .6 3 2.2 .6 .4",
    "atmosphere 1 mist .1 .2 .3 4 5 6 .5 3",
    "light 1 area 1 -2 3 2 -2 3 2 1 -1 3 2",
    "surface q translu .6 .5 .4 .3 9 diffuse .4 .5 .6\nsphere q 1.2 0 0 0",
};

bool IsNumber(const std::string& word) {
  char* end;
  std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == 0;
}

struct Outcome {
  bool said_something;
  bool finite;
};

// What becomes of the scene: rays through it from the eye and from elsewhere.
Outcome Render(const std::string& text) {
  Options options;
  options.program = "test";
  std::FILE* messages = std::tmpfile();
  Outcome outcome{false, true};
  {
    Diagnostics diagnostics("test", messages);
    SceneBuilder builder;
    bool good = ParseText(text, options, &diagnostics, &builder);
    if (good) {
      const SceneBuilder::Built built = builder.Build(0);
      OpCounts counts;
      for (const double x : {-.7, -.2, .3, .9}) {
        RayBundle bundle;
        bundle.rays = {TextScene::RayTo({x, -10, 3}, {-.1 * x, 1, -.3}),
                       TextScene::RayTo({0, 0, .1}, {x, .4, .2})};
        RayResult results[2];
        TraceBundle(*built.scene, *built.objects, bundle, results, &counts);
        for (const RayResult& r : results) {
          outcome.finite &=
              std::isfinite(r.color.r) && std::isfinite(r.color.g) && std::isfinite(r.color.b);
        }
      }
    }
  }
  outcome.said_something = std::ftell(messages) > 0;
  std::fclose(messages);
  return outcome;
}

// Calls visit(scene, statement) with `number` in each place of each statement.
template <class Visit>
void ForEachPlace(const std::string& number, const Visit& visit) {
  for (const std::string statement : kStatements) {
    std::vector<std::string> words;
    std::istringstream in(statement);
    for (std::string word; in >> word;) words.push_back(word);
    for (size_t place = 0; place < words.size(); ++place) {
      if (!IsNumber(words[place])) continue;
      std::string changed;
      for (size_t i = 0; i < words.size(); ++i) changed += (i == place ? number : words[i]) + " ";
      visit(kAround + changed + "\n", changed);
    }
  }
}

TEST(DegenerateInput, NumbersThatAreNoneGetAMessage) {
  for (const char* number : {"(0/0)", "(1/0)", "(-1/0)", "1e999", "(sqrt(-1))"}) {
    ForEachPlace(number, [](const std::string& scene, const std::string& changed) {
      const Outcome outcome = Render(scene);
      EXPECT_TRUE(outcome.said_something) << changed;
      EXPECT_TRUE(outcome.finite) << changed;
    });
  }
}

TEST(DegenerateInput, NumbersOfAnySizeMakeNoColourThatIsNone) {
  for (const char* number :
       {"0", "-1", "4.9e-324", "1e-300", "1e-5", "1e20", "1e39", "1e300", "1.7e308", "-1.7e308"}) {
    ForEachPlace(number, [](const std::string& scene, const std::string& changed) {
      EXPECT_TRUE(Render(scene).finite) << changed;
    });
  }
}

// Expressions of time are computed when it is too late for an error.
TEST(DegenerateInput, MovementsThatAreNoneMakeNoColourThatIsNone) {
  for (const char* number : {"(1/time)", "(0/time)", "(-1/time)", "(exp(1e9*time+1e9))",
                             "(sqrt(time-1))", "(1e308*(2+time))"}) {
    for (const std::string move : {"translate @ 0 0", "rotate 0 0 1 @", "scale 1 @ 1",
                                   "texture bump .3 translate @ 0 0", "rotate @ 1 1 30"}) {
      std::string text = std::string(kAround) + "shutter .5\nsphere 1.2 0 0 0 " + move + "\n";
      text.replace(text.find('@'), 1, number);
      try {
        EXPECT_TRUE(Render(text).finite) << text;
      } catch (const std::exception& error) {
        EXPECT_STREQ(error.what(), "Singular matrix.") << text;
      }
    }
  }
}

TEST(DegenerateInput, ColoursThatOverflowAreAsBrightAsCanBe) {
  TextScene scene("light 1e300 directional 0 -1 0\nsphere diffuse 1e300 1 -1e300 1 0 0 0\n");
  const Color color = scene.Trace({0, -10, 0}, {0, 1, 0}).color;
  EXPECT_EQ(color, (Color{1e300, 1e300, -1e300}));
}

TEST(DegenerateInput, ManyFactorsThatOverflowTogether) {
  const Outcome outcome = Render(
      "cutoff 0\nmaxdepth 7\nlight 1e300 -1e300 1 point 1 -9 4\nlight -1e300 1e300 1 point 2 -9 "
      "3\n"
      "sphere ambient -1e308 1e308 1 diffuse 1e300 1e300 1e300 specular 1e300 -1e300 0 reflect "
      "1e300 transp 1e200 index 1.1 1 0 0 0\nplane reflect -1e300 specular 1 1e300 1 0 0 -2 0 0 "
      "1\natmosphere 1 fog 1e308 -1e308 0 .1 .1 .1\n");
  EXPECT_TRUE(outcome.finite);
}

}  // namespace
}  // namespace rayshade::test
