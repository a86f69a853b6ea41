// Numbers that nobody means, in every place of a scene: a message, or an ordinary picture; never a
// colour that is no number.
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
              !std::isnan(r.color.r) && !std::isnan(r.color.g) && !std::isnan(r.color.b);
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
  for (const char* number : {"0", "-1", "4.9e-324", "1e-300", "1e-5", "1e20", "1e39", "1e300"}) {
    ForEachPlace(number, [](const std::string& scene, const std::string& changed) {
      EXPECT_TRUE(Render(scene).finite) << changed;
    });
  }
}

}  // namespace
}  // namespace rayshade::test
