// Scenes made for tests; see scenes.h.
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>

#include "rayshade/common/vector.h"

namespace rayshade::parallel {

namespace {

std::string Text(const char* format, auto... values) {
  char line[400];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

// A ball with nine smaller ones around it, in any arrangement that fills space unevenly.
void Flake(int size, const Vector& center, double radius, const Vector& axis, std::string* text) {
  *text += Text("sphere %s %.9g %.9g %.9g %.9g\n", radius > 0.1 ? "dull" : "shiny", radius,
                center.x, center.y, center.z);
  if (size == 0) return;
  Vector u = std::abs(axis.x) < 0.9 ? Cross(axis, {1, 0, 0}) : Cross(axis, {0, 1, 0});
  Normalize(&u);
  const Vector v = Cross(axis, u);
  for (int i = 0; i < 9; ++i) {
    const double turn = (i < 6 ? i : i + 0.5) * kPi / (i < 6 ? 3 : 1.5), rise = i < 6 ? 0.1 : 0.8;
    const double reach = std::sqrt(1 - rise * rise);
    const Vector d =
        Normalized(reach * std::cos(turn) * u + reach * std::sin(turn) * v + rise * axis);
    Flake(size - 1, center + (radius * 4 / 3) * d, radius / 3, d, text);
  }
}

std::string View(int pixels, const char* eye, const char* look, double fov = 45) {
  return Text(
      "screen %d %d\nsample 1 nojitter\ncontrast 1 1 1\nbackground .1 .2 .4\nup 0 0 1\nfov %g "
      "%g\neyep %s\nlookp %s\n",
      pixels, pixels, fov, fov, eye, look);
}

const char kSurfaces[] =
    "surface dull ambient .1 .1 .1 diffuse .5 .45 .35 specular .3 .3 .3 specpow 8\n"
    "surface shiny diffuse .4 .3 .3 specular .5 .5 .5 specpow 3 reflect .5\n"
    "surface mirror diffuse .05 .05 .05 specular .9 .9 .95 reflect 1\n"
    "surface glass specular .3 .3 .3 specpow 20 transp .9 body .8 .9 1 index 1.4 extinct .9 "
    "reflect .2\n"
    "surface red ambient .1 0 0 diffuse .8 .2 .2\n";

}  // namespace

std::string Balls(int size, int pixels) {
  std::string text =
      View(pixels, "2.1 1.3 1.7", "0 0 0") + kSurfaces + "light 1 point 4 3 2\ngrid 10 10 10\n";
  Flake(size, {0, 0, 0}, 0.5, {0, 0, 1}, &text);
  return text + "end\n";
}

std::string Room(int pixels) {
  std::string text;
  const std::function<void(const std::string&)> append = [&](const std::string& name) {
    std::ifstream file("scenes/" + name);
    EXPECT_TRUE(file.good()) << "scenes/" << name << ": tests run in the project's folder";
    for (std::string line; std::getline(file, line);) {
      if (line.rfind("#include \"", 0) == 0) {
        append(line.substr(10, line.find('"', 10) - 10));
      } else {
        text += line + "\n";
      }
    }
  };
  append("room8.ray");
  return text + Text("screen %d %d\n", pixels, pixels);
}

std::string FacingMirrors() {
  return View(16, "-.8 .3 .2", "1 0 0", 70) + kSurfaces +
         "maxdepth 12\ncutoff 0\nlight 1 point 0 0 3\n"
         "box mirror -1.1 -2 -2 -1 2 2\nbox mirror 1 -2 -2 1.1 2 2\nsphere red .2 0 .5 0\nsphere "
         "dull .1 .4 -.3 .1\n";
}

std::string GlassScene() {
  return View(40, "0 -7 3", "0 0 .6") + kSurfaces +
         "light .7 point 3 -4 6\nlight .5 directional -1 -1 2\nplane dull 0 0 -.5 0 0 1\n"
         "sphere glass 1 0 0 .8\nsphere red .3 0 0 .8\nsphere glass .5 -1.4 .2 .2\nsphere glass .4 "
         "-1.2 0 .3\n"
         "box glass 1.1 -1 -.4 1.3 1 1.5\nbox glass 1.3 -1 -.4 1.5 1 1.2\nsphere shiny .4 1.9 .5 "
         ".2\n"
         "polygon glass -2 -1.5 -.4 2 -1.5 -.4 2 -1.5 .3 -2 -1.5 .3\ncylinder glass .2 -2 1 -.5 -2 "
         "1 1.5\n";
}

std::string InstanceScene() {
  std::string text = View(40, "3 -9 6", "3 3 0") + kSurfaces +
                     "light 1 point 4 -6 9\nname tree list\n cone red .5 0 0 .5 0 0 0 1.6\n "
                     "cylinder dull .1 0 0 0 0 0 .6\n"
                     " sphere shiny .15 0 0 1.6\nend\nname row list\n";
  for (int i = 0; i < 6; ++i) text += Text(" object tree translate %d 0 0\n", i);
  text += "end\n";
  for (int i = 0; i < 5; ++i)
    text += Text("object row scale 1 1 %g rotate 0 0 1 %d translate 0 %g 0\n", 1 + 0.2 * i, 3 * i,
                 1.3 * i);
  return text + "plane dull 0 0 0 0 0 1\n";
}

std::vector<std::pair<std::string, std::string>> HardScenes() {
  std::vector<std::pair<std::string, std::string>> scenes;
  const std::string front = View(24, "0 -6 0", "0 0 0");
  const std::string light = std::string(kSurfaces) + "light 1 point 2 -5 4\n";

  std::string crowd;
  for (int i = 0; i < 60; ++i) {
    crowd += Text("sphere %s .02 %g %g %g\n", i % 2 ? "shiny" : "dull", 0.9 + 0.0011 * i,
                  0.9 - 0.003 * (i % 7), 0.9 + 0.004 * (i % 5));
  }
  scenes.emplace_back("all objects in one voxel", View(24, "1 -1 1", ".9 .9 .9", 10) + light +
                                                      crowd + "sphere red .1 -1 -1 -1\n");
  scenes.emplace_back(
      "empty voxels",
      front + light + "sphere red .3 -2 -2 -2\nsphere shiny .3 2 2 2\nsphere dull .2 -2 2 2\n");
  scenes.emplace_back("one object over all",
                      front + light +
                          "sphere shiny 2 0 0 0\nsphere red .2 1 -2 1\nsphere red .2 -1 -2 -1\n" +
                          crowd);
  scenes.emplace_back("a plane under everything",
                      front + light + "plane mirror 0 0 -1 0 0 1\nplane dull 0 3 0 0 1 0\n" +
                          crowd + "sphere red .5 0 0 0\n");

  std::string borders;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z)
        borders += Text("box %s %g %g %g %g %g %g\n", (x + y + z) % 2 ? "shiny" : "dull", x - .5,
                        y - .5, z - .5, x + .5, y + .5, z + .5);
    }
  }
  scenes.emplace_back("objects on borders and corners",
                      View(24, "4 -5 3", "0 0 0") + light + borders);
  scenes.emplace_back("rays along cell faces and edges",
                      View(17, "0 -6 0", "0 0 0", 30) + "light 1 point 0 -6 0\n" + kSurfaces +
                          "box mirror -2 1.9 -2 2 2 2\nsphere glass .5 0 0 0\nsphere red .25 0 1 "
                          "0\nsphere shiny .25 -1 0 0\n"
                          "sphere shiny .25 1 0 0\nsphere shiny .25 0 0 1\nsphere shiny .25 0 0 "
                          "-1\nbox dull -2 -2 -2 -1.9 -1.9 -1.9\n");
  scenes.emplace_back("rays along diagonals", View(17, "-4 -4 -4", "0 0 0", 30) +
                                                  "light 1 point -4 -4 -4\n" + kSurfaces + borders);
  scenes.emplace_back("mirrors facing across a border", FacingMirrors());
  scenes.emplace_back("eye inside an object", View(24, "0 0 0", "1 .3 .2", 80) + light +
                                                  "sphere shiny 5 0 0 0\nsphere red .4 2 .5 .4\n" +
                                                  crowd);
  scenes.emplace_back("eye on a border, far from most",
                      View(24, "0 0 0", "0 1 0", 60) + light +
                          "sphere red 1 0 4 0\nsphere dull 1 -4 0 0\nsphere dull 1 4 0 0\nsphere "
                          "shiny .3 .4 2 .4\nsphere dull 1 0 -4 0\n");
  std::string far = View(24, "1000000 999994 1000000", "1000000 1000000 1000000") + kSurfaces +
                    "light 1 point 1000002 999995 1000004\n";
  for (int i = 0; i < 20; ++i)
    far += Text("sphere %s .3 %.17g %.17g %.17g\n", i % 2 ? "shiny" : "dull", 1e6 - 2 + 0.21 * i,
                1e6 + 0.1 * (i % 3), 1e6 - 1 + 0.37 * (i % 6));
  scenes.emplace_back("a million units from the origin", far);
  scenes.emplace_back(
      "coincident objects",
      front + light +
          "sphere red 1 0 0 0\nsphere shiny 1 0 0 0\nbox dull -2 1 -2 2 2 2\nbox red -2 1 -2 2 2 "
          "2\npolygon red -1 -1 -1 1 -1 -1 1 -1 0\npolygon dull -1 -1 -1 1 -1 -1 1 -1 0\n" +
          crowd);
  scenes.emplace_back("flat scene",
                      front + light +
                          "polygon dull -2 0 -2 2 0 -2 2 0 2 -2 0 2\npolygon red -1 0 -1 1 0 -1 1 "
                          "0 1 -1 0 1\ntriangle shiny 0 0 0 1 0 0 0 0 1\n");
  scenes.emplace_back("nothing in view",
                      View(8, "0 -6 0", "0 -12 0") + light + "sphere red 1 0 0 0\n");
  scenes.emplace_back("only a plane",
                      View(16, "0 -6 2", "0 0 0") + light + "plane shiny 0 0 0 0 0 1\n");
  return scenes;
}

}  // namespace rayshade::parallel
