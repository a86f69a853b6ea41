// The rows of [rayshade4/3 s.16.1-16.5, 16.8]: one pixel of the original each, traced as a single
// ray along the view axis through a scene made from text.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>

#include "tests/shade/text_scene.h"

namespace rayshade {
namespace {

struct Row {
  const char* name;
  const char* scene;  // " ; " separates statements; abbreviations as in the specification
  int bytes[3];
  Color exact;
};

constexpr Color kBytesOnly{-1, -1, -1};

const Row kRows[] = {
    {"S1", "sphere 1 0 0 0", {114, 114, 114}, {0.447096, 0.447096, 0.447096}},
    {"S2", "surface b ; sphere b 1 0 0 0", {0, 0, 0}, {0, 0, 0}},
    {"S3", "background .2 .4 .6 ; sphere transp .5 1 0 0 0", {12, 25, 38}, {0.05, 0.1, 0.15}},
    {"S4",
     "background .2 .4 .6 ; sphere transp 1 body .5 1 .25 1 0 0 0",
     {12, 102, 9},
     {0.05, 0.4, 0.0375}},
    {"S5", "background 1 1 1 ; sphere reflect 1 1 0 0 0", {0, 0, 0}, {0, 0, 0}},
    {"S6",
     "light 1 directional 1 -2 0 ; disc specular 1 1 1 specpow 4 2 0 0 0 0 -1 0",
     {163, 163, 163},
     {0.64, 0.64, 0.64}},
    {"S7",
     "light 1 directional 0 -1 0 ; sphere specular 1 1 1 specpow 0 1 0 0 0",
     {0, 0, 0},
     {0, 0, 0}},
    {"S8",
     "surface a diffuse 1 0 0 ambient .1 .1 .1 ; light 1 directional 0 -1 0 ; sphere a diffuse 0 "
     ".5 0 1 0 0 0",
     {25, 153, 25},
     {0.1, 0.6, 0.1}},
    {"S9",
     "applysurf ambient .3 .3 .3 ; list applysurf ambient .5 .5 .5 sphere 1 0 0 0 end",
     {127, 127, 127},
     {0.5, 0.5, 0.5}},
    {"S10",
     "name s list sphere 1 0 0 0 end ; object ambient .2 .2 .2 s",
     {51, 51, 51},
     {0.2, 0.2, 0.2}},
    {"S11",
     "light .5 ambient ; sphere ambient .2 .2 .2 diffuse .5 .5 .5 1 0 0 0",
     {99, 99, 99},
     {0.388675, 0.388675, 0.388675}},
    {"L1",
     "light 1 directional 0 -1 0 ; light 1 directional 0 1 0 ; TRL",
     {191, 191, 191},
     {0.75, 0.75, 0.75}},
    {"L2",
     "light 1 directional 0 1 0 ; light 1 directional 0 -1 0 ; TRL",
     {140, 140, 140},
     {0.55, 0.55, 0.55}},
    {"L3", "light 1 spot 0 -5 0 0 0 0 1 ; D2", {0, 0, 0}, {0, 0, 0}},
    {"L4",
     "light 1 spot 1 -5 0 1 0 0 1 5 30 ; D2",
     {235, 235, 235},
     {0.923353, 0.923353, 0.923353}},
    {"L5",
     "light 1 spot 1 -5 0 1 0 0 3 90 90 ; D2",
     {235, 235, 235},
     {0.924556, 0.924556, 0.924556}},
    {"L6", "light .5 point 0 -1000 0 ; D2", {127, 127, 127}, {0.5, 0.5, 0.5}},
    {"L7",
     "light .5 .25 1 point 0 -5 0 noshadow ; sphere .1 0 -4 1 ; D2",
     {127, 63, 255},
     {0.5, 0.25, 1}},
    {"T1", "BG sphere transp 1 extinct .8 1 0 0 0", {130, 65, 32}, {0.512, 0.256, 0.128}},
    {"T2",
     "BG sphere transp 1 extinct .5 1 0 0 0 ; sphere transp 1 extinct .25 .5 0 0 0",
     {25, 12, 6},
     {0.1, 0.05, 0.025}},
    {"T3", "BG poly transp 1 extinct .999 -5 0 -5 5 0 -5 5 0 5 -5 0 5", {0, 0, 0}, {0, 0, 0}},
    {"T4",
     "BG poly transp 1 extinct .999 -5 0 5 5 0 5 5 0 -5 -5 0 -5",
     {204, 102, 51},
     {0.8, 0.4, 0.2}},
    {"T5",
     "BG plane transp .5 body .5 1 1 index 2 0 0 0 .866025403784 .5 0",
     {51, 51, 25},
     {0.2, 0.2, 0.1}},
    {"T6",
     "BG plane transp .5 body .5 1 1 index 2 reflect .5 specular .5 .5 .5 0 0 0 .866025403784 .5 0",
     {102, 76, 38},
     {0.4, 0.3, 0.15}},
    {"T7",
     "BG box transp 1 extinct .5 -1 -1 -1 1 1 1 ; disc specular 1 1 1 reflect 1 .9 0 0 0 0 1 0",
     {102, 51, 25},
     {0.4, 0.2, 0.1}},
    {"T8",
     "BG box transp 1 extinct .5 -1 -1 -1 1 0 1 ; box transp 1 extinct .5 -1 0 -1 1 1 1",
     {0, 0, 0},
     {0, 0, 0}},
    {"T9",
     "BG difference sphere transp 1 extinct .5 1 0 0 0 sphere transp 1 extinct .5 .5 0 0 0 end",
     {102, 51, 25},
     {0.4, 0.2, 0.1}},
    {"T10",
     "light 1 point 1 1 0 ; plane transp 1 noshadow index 1.5 0 0 0 .642787609687 -.766044443119 0 "
     "; plane diffuse .9 .9 .9 noshadow 0 3 0 0 1 0",
     {171, 171, 171},
     {0.671814, 0.671814, 0.671814}},
    {"T11", "BG atmosphere 1.9 ; TIRS", {6, 63, 6}, {0.025, 0.25, 0.025}},
    {"T12", "BG atmosphere 2 ; TIRS", {102, 51, 25}, {0.4, 0.2, 0.1}},
    {"T13", "maxdepth 0 ; MIRR", {25, 25, 25}, {0.1, 0.1, 0.1}},
    {"T14", "maxdepth 1 ; MIRR", {38, 38, 38}, {0.15, 0.15, 0.15}},
    {"T15", "maxdepth 3 ; MIRR", {47, 47, 47}, {0.1875, 0.1875, 0.1875}},
    {"T16", "cutoff .25 ; MIRR", {38, 38, 38}, {0.15, 0.15, 0.15}},
    {"T17", "cutoff .2499 ; MIRR", {44, 44, 44}, {0.175, 0.175, 0.175}},
    {"T18", "maxdepth 20 ; MIRR", {50, 50, 50}, {0.199609, 0.199609, 0.199609}},
    {"W1",
     "eyep 6 -8 0 fov 10 ; PL sphere transp .8 body 1 .5 .25 extinct .9 index 1.5 1 0 -20 0",
     {132, 33, 8},
     {0.518401, 0.1296, 0.0324}},
    {"W2",
     "eyep 6 -8 0 fov 10 ; PL shadowtransp ; sphere transp .8 body 1 .5 .25 1 0 -20 0",
     {0, 0, 0},
     {0, 0, 0}},
    {"W3",
     "eyep 6 -8 0 fov 10 ; PL sphere transp 1 extinct .5 1 0 -20 0 ; sphere transp 1 extinct .5 2 "
     "0 -20 0",
     {31, 31, 31},
     {0.125002, 0.125002, 0.125002}},
    {"W4",
     "eyep 6 -8 0 fov 10 ; PL sphere transp 1 extinct .5 2 0 -50 0",
     {255, 255, 255},
     {1, 1, 1}},
    {"W5",
     "eyep 6 -8 0 fov 10 ; PL sphere diffuse 1 1 1 1 0 -20 0 texture sky 1 .5 2 4 .99 .98",
     {0, 0, 0},
     {0, 0, 0}},
    {"W6",
     "eyep 6 -8 0 fov 10 ; PL sphere diffuse 1 1 1 transp .01 1 0 -20 0 texture sky 1 .5 2 4 .99 "
     ".98",
     {255, 255, 255},
     {1, 1, 1}},
    {"A1", "BG atmosphere fog .9 .1 .3 14 5 1 ; D5", {167, 35, 76}, {0.656197, 0.1375, 0.300684}},
    {"A2",
     "BG atmosphere fog 1 0 0 10 10 10 fog 0 0 1 5 5 5 ; D5",
     {143, 7, 127},
     {0.5625, 0.03125, 0.5}},
    {"A3",
     "BG atmosphere fog 1 0 0 10 10 10 ; atmosphere fog 0 0 1 5 5 5 ; D5",
     {31, 15, 255},
     {0.125, 0.0625, 1}},
    {"A4",
     "BG atmosphere fog 1 0 0 10 10 10 ; poly transp 1 -5 -5 -5 5 -5 -5 5 -5 5 -5 -5 5 ; D5",
     {164, 45, 180},
     {0.646447, 0.176777, 0.707107}},
    {"A5",
     "BG sphere .1 50 50 50 ; atmosphere fog .9 .1 .3 14 5 1",
     {229, 25, 76},
     {0.9, 0.1, 0.3}},
    {"A6",
     "eyep 0 -10 2 lookp 0 0 -1 ; BG atmosphere mist .9 .1 .3 14 5 30 .5 3 ; D5",
     {181, 30, 202},
     {0.7114, 0.118274, 0.792859}},
    {"A7",
     "eyep 0 -10 2 lookp 0 0 -1 ; BG atmosphere fogdeck 1 .1 1 1 1 .5 4 .9 .1 .3 5 5 5 ; D5",
     {127, 63, 255},
     {0.5, 0.25, 1}},
    {"A8",
     "eyep 0 -10 2 lookp 0 0 2 ; BG atmosphere mist .9 .1 .3 14 5 30 .5 3 ; D5",
     {162, 37, 223},
     {0.636944, 0.146394, 0.875651}},
    {"A9",
     "eyep .3 .2 5 lookp .3 .2 0 up 0 1 0 ; BG atmosphere fogdeck 1 .1 1 1 1 .5 4 .9 .1 .3 5 5 5 ; "
     "plane ambient .5 .25 1 0 0 -3 0 0 1",
     {140, 58, 232},
     {0.551478, 0.230696, 0.909913}},
    {"N1",
     "light 1 directional -.9 -.43588989435 0 ; triangle diffuse 1 1 1 -3 0 -3 .9 -.43588989435 0  "
     "3 0 -3 .9 -.43588989435 0  0 0 4 .9 -.43588989435 0",
     {111, 111, 111},
     kBytesOnly},
    {"N2",
     "light 1 directional -.9 -.43588989435 0 ; triangle diffuse 1 1 1 0 3 -3 -.43588989435 -.9 0  "
     "0 -3 -3 -.43588989435 -.9 0  0 0 4 -.43588989435 -.9 0 rotate 0 0 1 90",
     {111, 111, 111},
     kBytesOnly},
    {"N3",
     "light 1 directional -.9 -.43588989435 0 ; triangle diffuse 1 1 1 0 3 -3 -.43588989435 -.9 0  "
     "0 -3 -3 -.43588989435 -.9 0  0 0 4 -.43588989435 -.9 0 rotate 0 0 1 90 texture bump 0",
     {229, 229, 229},
     kBytesOnly},
    {"N4",
     "atmosphere fog 1 0 0 50 50 50 ; light 0 directional 0 -1 0 ; plane specular 1 1 1 reflect 1 "
     "0 0 0 0 -1 0 texture fbmbump .2 0 .5 2 1 ; plane ambient .5 .5 .5 0 -20 0 0 1 0",
     {213, 41, 41},
     kBytesOnly},
};

std::string Expanded(const std::string& scene) {
  static const std::pair<const char*, const char*> kAbbreviations[] = {
      {"BG", "background .8 .4 .2 light 0 directional 0 -1 0"},
      {"D5", "disc ambient .5 .25 1  5  0 0 0  0 -1 0"},
      {"D2", "disc diffuse 1 1 1  2  0 0 0  0 -1 0"},
      {"TRL",
       "disc ambient .1 .1 .1 diffuse .4 .4 .4 body 0 0 0 translu .5 .6 .6 .6 10  2  0 0 0  0 -1 "
       "0"},
      {"MIRR",
       "plane ambient .1 .1 .1 specular 1 1 1 reflect .5  0 5 0  0 1 0 "
       "plane ambient .1 .1 .1 specular 1 1 1 reflect .5  0 -15 0  0 1 0 light 0 directional 0 -1 "
       "0"},
      {"TIRS",
       "plane transp .5 index 1.2  0 0 0  .866025403784 .5 0 "
       "plane ambient .05 .5 .05  -3 0 0  1 0 0"},
      {"PL", "light 1 point 0 -50 0 plane diffuse 1 1 1  0 0 0  0 -1 0"},
  };
  std::string text = "eyep 0 -10 0\nlookp 0 0 0\nfov 45\nscreen 3 3\nsample 1 nojitter\n";
  std::istringstream words(scene);
  for (std::string word; words >> word;) {
    for (const auto& [from, to] : kAbbreviations) {
      if (word == from) word = to;
    }
    text += word == ";" ? "\n" : word + " ";
  }
  return text + "\n";
}

class CheckedExample : public testing::TestWithParam<Row> {};

TEST_P(CheckedExample, HasTheOriginalsPixel) {
  const Row& row = GetParam();
  test::TextScene scene(Expanded(row.scene));
  const Color color = scene.AlongView().color;
  for (int channel = 0; channel < 3; ++channel) {
    const double clamped = std::clamp(color[channel], 0.0, 1.0);
    EXPECT_EQ(static_cast<int>(255 * clamped), row.bytes[channel]) << row.scene;
    if (row.exact != kBytesOnly) {
      EXPECT_NEAR(color[channel], row.exact[channel], 6e-7) << row.scene;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Section16, CheckedExample, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace rayshade
