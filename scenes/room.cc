// room: a conference room in the Rayshade language, on standard output: what scenes/room8.ray and
// scenes/room30.ray include. It is the project's own, with the kind of content of the room that
// [RJ s.5] renders: 11 x 7 x 2.7 m, a table with sixteen chairs, blinds, luminaires, shelves, more
// than 20,000 polygons. View and lights stand in the two scene files.
#include "scenes/room_furniture.h"
#include "scenes/room_shell.h"

namespace room {
namespace {

constexpr Vector kTable{6, 3.4, 0.74};  // the middle of the table's top

constexpr char kSurfaces[] =
    "surface wall ambient .15 .145 .13 diffuse .6 .58 .53\n"
    "surface accent_wall ambient .1 .13 .15 diffuse .36 .47 .55\n"
    "surface ceiling_tile ambient .5 .5 .47 diffuse .84 .84 .8\n"
    "surface white_metal ambient .34 .34 .33 diffuse .75 .75 .75 specular .2 .2 .2 specpow 30\n"
    "surface carpet_dark ambient .05 .06 .08 diffuse .17 .22 .29\n"
    "surface carpet_light ambient .06 .075 .095 diffuse .22 .28 .36\n"
    "surface table_wood ambient .09 .045 .02 diffuse .38 .19 .09 specular .3 .3 .3 specpow 60 "
    "reflect .12\n"
    "surface oak ambient .11 .07 .035 diffuse .46 .29 .15 specular .08 .08 .08 specpow 30\n"
    "surface chrome ambient .02 .02 .02 diffuse .12 .12 .13 specular .7 .7 .7 specpow 80 reflect "
    ".6\n"
    "surface grey_metal ambient .1 .1 .1 diffuse .4 .4 .42 specular .4 .4 .4 specpow 40 reflect "
    ".1\n"
    "surface cloth ambient .13 .03 .03 diffuse .55 .12 .1\n"
    "surface black_plastic ambient .015 .015 .015 diffuse .06 .06 .06 specular .2 .2 .2 specpow "
    "20\n"
    "surface display ambient .05 .07 .1 diffuse .05 .06 .08 specular .4 .4 .4 specpow 90 reflect "
    ".1\n"
    "surface glass ambient 0 0 0 diffuse .02 .03 .03 specular .5 .5 .5 specpow 100 reflect .12 "
    "transp .85 index 1\n"
    "surface evening ambient .16 .22 .36\n"
    "surface slat ambient .17 .16 .13 diffuse .7 .66 .55 specular .1 .1 .1 specpow 20\n"
    "surface lamp ambient 1 1 .94 diffuse .2 .2 .2\n"
    "surface board ambient .13 .13 .14 diffuse .5 .5 .52 specular .2 .2 .2 specpow 60 reflect "
    ".05\n"
    "surface paper ambient .22 .22 .2 diffuse .8 .8 .75\n"
    "surface china ambient .2 .2 .2 diffuse .75 .75 .72 specular .5 .5 .5 specpow 60\n"
    "surface coffee ambient .02 .01 0 diffuse .1 .05 .02 specular .4 .4 .4 specpow 60\n"
    "surface clay ambient .12 .06 .04 diffuse .5 .26 .16\n"
    "surface soil ambient .02 .015 .01 diffuse .1 .07 .05\n"
    "surface leaf ambient .03 .09 .03 diffuse .12 .38 .1 specular .1 .1 .1 specpow 20\n"
    "surface red ambient .14 .02 .02 diffuse .6 .08 .07\n"
    "surface green ambient .03 .1 .04 diffuse .1 .42 .18\n"
    "surface blue ambient .03 .05 .13 diffuse .12 .2 .55\n"
    "surface ochre ambient .15 .1 .02 diffuse .62 .42 .1\n"
    "surface grey ambient .09 .09 .09 diffuse .36 .36 .38\n";

// A number from 0 to 1 that looks like chance and is always the same for the same two.
double Chance(int a, int b) {
  const double wave = std::sin(a * 12.9898 + b * 78.233) * 43758.5453;
  return wave - std::floor(wave);
}

void DrawShelves(Drawing* draw, double x0) {
  constexpr const char* kBindings[] = {"red", "green", "blue", "ochre", "grey", "paper", "cloth"};
  const int bays = 4, boards = 6;
  const double bay = 0.9, depth = 0.3, step = 0.36;
  draw->Use("oak");
  for (int i = 0; i <= bays; ++i) {
    draw->Box(Frame{}, {x0 + i * bay - 0.01, 0, 0}, {x0 + i * bay + 0.01, depth, 5 * step + 0.08});
  }
  for (int i = 0; i < boards; ++i) {
    draw->Box(Frame{}, {x0, 0, 0.06 + i * step}, {x0 + bays * bay, depth, 0.08 + i * step});
  }
  for (int i = 0; i < bays; ++i) {
    for (int j = 0; j + 1 < boards; ++j) {
      double x = x0 + i * bay + 0.015;
      const double full = x0 + (i + 0.55 + 0.4 * Chance(i, j)) * bay;
      for (int book = 0; x < full; ++book) {
        const int key = 100 * i + 10 * j;
        const double thick = 0.018 + 0.034 * Chance(key, book),
                     high = 0.2 + 0.1 * Chance(book, key),
                     deep = 0.15 + 0.06 * Chance(key + 5, book);
        const int binding = static_cast<int>(7 * Chance(key + 7, book + 3));
        DrawBook(draw, Frame{}.Moved(x + thick / 2, depth - 0.03, 0.08 + j * step),
                 {thick, deep, high}, kBindings[binding]);
        x += thick + 0.001;
      }
    }
  }
}

void DrawBoard(Drawing* draw) {
  const double x = kLength;
  draw->Use("board");
  draw->Polygon(
      Frame{},
      {{x - 0.02, 1.6, 0.95}, {x - 0.02, 5.4, 0.95}, {x - 0.02, 5.4, 2.15}, {x - 0.02, 1.6, 2.15}});
  draw->Use("grey_metal");
  draw->Box(Frame{}, {x - 0.03, 1.56, 0.91}, {x, 5.44, 0.95});
  draw->Box(Frame{}, {x - 0.03, 1.56, 2.15}, {x, 5.44, 2.19});
  draw->Box(Frame{}, {x - 0.03, 1.56, 0.95}, {x, 1.6, 2.15});
  draw->Box(Frame{}, {x - 0.03, 5.4, 0.95}, {x, 5.44, 2.15});
  draw->Box(Frame{}, {x - 0.1, 2.6, 0.9}, {x, 4.4, 0.915});
  constexpr const char* kInks[] = {"red", "blue", "green", "black_plastic"};
  for (int i = 0; i < 4; ++i) {
    draw->Use(kInks[i]);
    draw->Tube(Frame{}, {{x - 0.05, 2.8 + 0.2 * i, 0.925}, {x - 0.05, 2.93 + 0.2 * i, 0.925}},
               0.009, 8);
  }
  // Something was explained here.
  for (int i = 0; i < 60; ++i) {
    const double a = 2.1 + 0.04 * i, b = a + 0.04;
    const auto curve = [](double t) { return 1.5 + 0.4 * std::sin(3 * t) * std::exp(-0.35 * t); };
    draw->Use("blue");
    draw->Polygon(Frame{}, {{x - 0.021, a, curve(a - 2)},
                            {x - 0.021, b, curve(b - 2)},
                            {x - 0.021, b, curve(b - 2) + 0.014},
                            {x - 0.021, a, curve(a - 2) + 0.014}});
  }
  draw->Use("black_plastic");
  draw->Polygon(
      Frame{},
      {{x - 0.021, 2, 1.45}, {x - 0.021, 4.7, 1.45}, {x - 0.021, 4.7, 1.46}, {x - 0.021, 2, 1.46}});
  draw->Polygon(
      Frame{},
      {{x - 0.021, 2, 1.1}, {x - 0.021, 2.01, 1.1}, {x - 0.021, 2.01, 2}, {x - 0.021, 2, 2}});
}

void DrawTable(Drawing* draw) {
  const int corners = 80;
  const Frame table = Frame{}.Moved(kTable.x, kTable.y, 0);
  const auto outline = [&](double inset, double z) {
    std::vector<Vector> points;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / corners;
      const double c = std::cos(angle), s = std::sin(angle);
      points.push_back({(2.9 - inset) * std::copysign(std::pow(std::abs(c), 0.36), c),
                        (0.8 - inset) * std::copysign(std::pow(std::abs(s), 0.62), s), z});
    }
    return points;
  };
  draw->Use("table_wood");
  std::vector<std::vector<Vector>> rings{outline(0.05, 0.695), outline(0.01, 0.705),
                                         outline(0, 0.72), outline(0.006, 0.735),
                                         outline(0.015, kTable.z)};
  for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
    for (int i = 0; i < corners; ++i) {
      const int next = (i + 1) % corners;
      const Vector &a = rings[ring][i], &b = rings[ring][next], &c = rings[ring + 1][next],
                   &d = rings[ring + 1][i];
      draw->Polygon(table, {a, b, c});
      draw->Polygon(table, {a, c, d});
    }
  }
  draw->Polygon(table, rings.back());
  draw->Polygon(table, {rings.front().rbegin(), rings.front().rend()});
  for (const double x : {-1.9, 0.0, 1.9}) {
    draw->Use("oak");
    draw->Box(table, {x - 0.3, -0.06, 0.05}, {x + 0.3, 0.06, 0.695});
    draw->Use("chrome");
    draw->Box(table, {x - 0.35, -0.35, 0}, {x + 0.35, 0.35, 0.05});
    draw->Box(table, {x - 0.22, -0.07, kTable.z + 0.0005}, {x + 0.22, 0.07, kTable.z + 0.005});
  }
}

void DrawTableThings(Drawing* draw) {
  const Frame top = Frame{}.Moved(kTable.x, kTable.y, kTable.z);
  for (int i = 0; i < 7; ++i) {
    for (const int side : {-1, 1}) {
      const Frame place = top.Moved(-2.34 + 0.78 * i, side * 0.5, 0).Turned(side > 0 ? 180 : 0);
      const double chance = Chance(i, side + 2);
      if ((i + side + 1) % 3 == 0) {
        DrawLaptop(draw, place.Turned(20 * chance - 10));
      } else {
        draw->Use("paper");
        draw->Box(place.Turned(30 * chance - 15), {-0.105, -0.15, 0}, {0.105, 0.147, 0.006});
        draw->Use(chance < 0.5 ? "blue" : "red");
        draw->Tube(place.Turned(60 * chance), {{0.13, -0.07, 0.005}, {0.13, 0.07, 0.005}}, 0.004,
                   6);
      }
      if ((2 * i + side + 1) % 3 != 1) {
        DrawMug(draw, place.Moved(0.25, 0.1 + 0.05 * chance, 0).Turned(360 * chance),
                chance < 0.6 ? "china" : "blue");
      }
    }
  }
  const Frame phone = top.Moved(0.95, 0, 0);
  draw->Use("black_plastic");
  for (int leg = 0; leg < 3; ++leg) {
    draw->Cushion(phone.Turned(120 * leg).Moved(0.09, 0, 0.022), {0.1, 0.045, 0.02}, 0.6, 6, 16);
  }
  draw->Use("grey_metal");
  draw->Lathe(phone, {{0.07, 0.02}, {0.065, 0.045}, {0.04, 0.055}, {0, 0.057}}, 24);
}

void DrawChairs(Drawing* draw) {
  const Frame middle = Frame{}.Moved(kTable.x, kTable.y, 0);
  for (int i = 0; i < 7; ++i) {
    for (const int side : {-1, 1}) {
      const double chance = Chance(3 * i, side + 5);
      DrawChair(draw, middle.Moved(-2.34 + 0.78 * i, side * (1.02 + 0.14 * chance), 0)
                          .Turned((side > 0 ? 180 : 0) + 36 * Chance(i, side + 9) - 18));
    }
  }
  DrawChair(draw, middle.Moved(-3.25, 0.05, 0).Turned(-75));
  DrawChair(draw, middle.Moved(3.3, -0.05, 0).Turned(100));
  for (int i = 0; i < 3; ++i) {
    DrawChair(draw, Frame{}.Moved(2.1 + 0.8 * i, 0.5, 0).Turned(8 * i - 8));
  }
}

void DrawRoom() {
  Drawing draw;
  std::printf("/* A conference room of 11 x 7 x 2.7 m. Made by room (scenes/room.cc). */\n%s",
              kSurfaces);
  std::printf("grid 44 28 12\n");
  DrawFloorAndCeiling(&draw);
  DrawEndWalls(&draw);
  DrawWindowWall(&draw);
  DrawDoor(&draw, 8.6);
  DrawShelves(&draw, 4.5);
  DrawBoard(&draw);
  DrawCeilingThings(&draw);
  DrawTable(&draw);
  DrawTableThings(&draw);
  DrawChairs(&draw);
  DrawPlant(&draw, Frame{}.Moved(10.45, 0.55, 0));
  DrawPlant(&draw, Frame{}.Moved(10.4, 6.35, 0));
  std::printf("end\n/* %d polygons */\n", draw.polygon_count());
}

}  // namespace
}  // namespace room

int main() {
  room::DrawRoom();
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    std::perror("room");
    return 1;
  }
}
