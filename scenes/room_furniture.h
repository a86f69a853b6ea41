// The movable things of the room, each a function of its own: the frame's origin is where the thing
// stands, its local y axis the way it faces.
#pragma once

#include "scenes/room_shapes.h"

namespace room {

// A swivel chair with arms; whoever sits on it looks along +y.
inline void DrawChair(Drawing* draw, const Frame& chair) {
  draw->Use("chrome");
  for (int leg = 0; leg < 5; ++leg) {
    const Frame spoke = chair.Turned(18 + 72 * leg);
    draw->Slab(spoke, {{0.03, -0.025}, {0.3, -0.014}, {0.3, 0.014}, {0.03, 0.025}}, 0.075, 0.1);
    draw->Sphere(spoke, 0.035, {0.285, 0, 0.036});
  }
  draw->Lathe(chair, {{0.032, 0.07}, {0.032, 0.24}, {0.02, 0.25}, {0.02, 0.41}}, 10);
  draw->Tube(chair, {{0, -0.05, 0.415}, {0, -0.3, 0.425}, {0, -0.335, 0.5}, {0, -0.31, 0.72}}, 0.02,
             8);
  draw->Use("cloth");
  draw->Cushion(chair.Moved(0, 0, 0.46), {0.25, 0.25, 0.05}, 0.45, 8, 24);
  draw->Cushion(chair.Moved(0, -0.26, 0.8).Tilted(10), {0.215, 0.04, 0.21}, 0.5, 8, 20);
  for (const double side : {-1.0, 1.0}) {
    draw->Use("chrome");
    const double x = side * 0.28;
    draw->Tube(chair, {{side * 0.15, 0, 0.42}, {x, 0, 0.43}, {x, 0.02, 0.5}, {x, 0.03, 0.64}},
               0.013, 6);
    draw->Use("black_plastic");
    draw->Cushion(chair.Moved(x, 0, 0.655), {0.035, 0.14, 0.018}, 0.6, 4, 10);
  }
}

// An open laptop; its screen faces along -y, to whoever sits there.
inline void DrawLaptop(Drawing* draw, const Frame& laptop) {
  draw->Use("grey_metal");
  draw->Box(laptop, {-0.16, -0.11, 0}, {0.16, 0.11, 0.014});
  const Frame lid = laptop.Moved(0, 0.115, 0.012).Tilted(-20);
  draw->Box(lid, {-0.16, 0, 0}, {0.16, 0.008, 0.215});
  draw->Use("display");
  draw->Polygon(lid, {{-0.15, -0.001, 0.015},
                      {0.15, -0.001, 0.015},
                      {0.15, -0.001, 0.205},
                      {-0.15, -0.001, 0.205}});
  draw->Use("black_plastic");
  for (int row = 0; row < 5; ++row) {
    for (int key = 0; key < 13; ++key) {
      const double x = -0.1435 + 0.0222 * key, y = -0.025 + 0.0222 * row;
      draw->Box(laptop, {x, y, 0.0145}, {x + 0.018, y + 0.018, 0.0165});
    }
  }
}

inline void DrawMug(Drawing* draw, const Frame& mug, const char* surface) {
  draw->Use(surface);
  draw->Lathe(mug,
              {{0, 0.004},
               {0.028, 0.004},
               {0.032, 0},
               {0.037, 0.03},
               {0.04, 0.09},
               {0.036, 0.09},
               {0.033, 0.03},
               {0.028, 0.01}},
              18);
  draw->Tube(mug,
             {{0.036, 0, 0.075},
              {0.055, 0, 0.078},
              {0.066, 0, 0.06},
              {0.064, 0, 0.04},
              {0.05, 0, 0.025},
              {0.036, 0, 0.025}},
             0.005, 6);
  draw->Use("coffee");
  draw->Disc(mug, 0.036, {0, 0, 0.07}, {0, 0, 1});
}

// A book on end, its spine facing along +y.
inline void DrawBook(Drawing* draw, const Frame& book, const Vector& size, const char* surface) {
  const double x = size.x / 2, bulge = 0.006;
  draw->Use(surface);
  draw->Slab(book,
             {{-x, -size.y},
              {-x + 0.003, -size.y},
              {-x + 0.003, -0.002},
              {x - 0.003, -0.002},
              {x - 0.003, -size.y},
              {x, -size.y},
              {x, 0},
              {x / 2, bulge},
              {-x / 2, bulge},
              {-x, 0}},
             0, size.z);
  draw->Use("paper");
  draw->Box(book, {-x + 0.003, -size.y + 0.005, 0.003}, {x - 0.003, -0.002, size.z - 0.004});
}

// A pot with long bent leaves.
inline void DrawPlant(Drawing* draw, const Frame& plant) {
  draw->Use("clay");
  draw->Lathe(plant,
              {{0.13, 0}, {0.19, 0.32}, {0.21, 0.32}, {0.21, 0.37}, {0.18, 0.37}, {0.17, 0.3}}, 28);
  draw->Use("soil");
  draw->Disc(plant, 0.172, {0, 0, 0.33}, {0, 0, 1});
  draw->Use("leaf");
  for (int i = 0; i < 110; ++i) {
    const double turn = 137.5 * i, reach = 0.18 + 0.0028 * i, height = 1.25 - 0.0068 * i;
    const Frame leaf = plant.Turned(turn);
    Vector left{0.02, 0.012, 0.33}, right{0.02, -0.012, 0.33};
    for (int part = 1; part <= 5; ++part) {
      const double t = part / 5.0, width = 0.03 * (1 - t * t) + 0.002;
      const double x = 0.02 + reach * t, z = 0.33 + height * (t - 0.45 * t * t);
      const Vector next_left{x, width, z}, next_right{x, -width, z};
      draw->Polygon(leaf, {left, right, next_right, next_left});
      left = next_left;
      right = next_right;
    }
  }
}

}  // namespace room
