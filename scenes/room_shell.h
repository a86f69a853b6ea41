// The room itself: floor, ceiling, walls, windows, door, and what hangs under the ceiling.
//
// The long walls run along x. Windows are in the wall y = 7, the door in y = 0.
#pragma once

#include "scenes/room_shapes.h"

namespace room {

inline constexpr double kLength = 11, kWidth = 7, kHeight = 2.7;

inline void DrawFloorAndCeiling(Drawing* draw) {
  const Frame room;
  for (int i = 0; i < 22; ++i) {
    for (int j = 0; j < 14; ++j) {
      draw->Use((i + j) % 2 == 0 ? "carpet_dark" : "carpet_light");
      const double x = 0.5 * i, y = 0.5 * j;
      draw->Polygon(room, {{x, y, 0}, {x + 0.5, y, 0}, {x + 0.5, y + 0.5, 0}, {x, y + 0.5, 0}});
    }
  }
  // Bevelled tiles between the bars of a grid.
  const int columns = 18, rows = 12;
  const double dx = kLength / columns, dy = kWidth / rows, bar = 0.012, bevel = 0.02, up = 0.012;
  draw->Use("ceiling_tile");
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double x0 = i * dx + bar, x1 = (i + 1) * dx - bar, y0 = j * dy + bar,
                   y1 = (j + 1) * dy - bar, z = kHeight, low = kHeight - up;
      const std::vector<Vector> outer{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
      const std::vector<Vector> inner{{x0 + bevel, y0 + bevel, low},
                                      {x1 - bevel, y0 + bevel, low},
                                      {x1 - bevel, y1 - bevel, low},
                                      {x0 + bevel, y1 - bevel, low}};
      draw->Polygon(room, inner);
      for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        draw->Polygon(room, {outer[k], outer[next], inner[next], inner[k]});
      }
    }
  }
  draw->Use("white_metal");
  draw->Polygon(
      room,
      {{0, 0, kHeight}, {0, kWidth, kHeight}, {kLength, kWidth, kHeight}, {kLength, 0, kHeight}});
}

// A rectangle in the wall y = `y`, from (x0, z0) to (x1, z1).
inline void WallPart(Drawing* draw, double y, double x0, double z0, double x1, double z1) {
  draw->Polygon(Frame{}, {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}});
}

inline void DrawBlind(Drawing* draw, double x0, double x1, double bottom, double top) {
  draw->Use("slat");
  draw->Box(Frame{}, {x0, 6.9, top - 0.05}, {x1, 6.95, top});
  const int parts = 3;
  for (double z = bottom; z < top - 0.06; z += 0.027) {
    const Frame slat = Frame{}.Moved(0, 6.925, z).Tilted(-28);
    for (int i = 0; i < parts; ++i) {
      const double a = x0 + (x1 - x0) * i / parts, b = x0 + (x1 - x0) * (i + 1) / parts;
      draw->Polygon(slat, {{a, -0.0125, 0}, {b, -0.0125, 0}, {b, 0, 0.003}, {a, 0, 0.003}});
      draw->Polygon(slat, {{a, 0, 0.003}, {b, 0, 0.003}, {b, 0.0125, 0}, {a, 0.0125, 0}});
    }
  }
  draw->Use("white_metal");
  for (const double part : {0.15, 0.5, 0.85}) {
    const double x = x0 + part * (x1 - x0);
    draw->Cylinder(Frame{}, 0.0015, {x, 6.909, bottom}, {x, 6.909, top});
  }
}

inline void DrawRadiator(Drawing* draw, double x0, double x1) {
  draw->Use("white_metal");
  for (double x = x0; x < x1; x += 0.06) {
    draw->Box(Frame{}, {x, 6.86, 0.12}, {x + 0.035, 6.95, 0.7});
  }
  draw->Cylinder(Frame{}, 0.02, {x0, 6.905, 0.16}, {x1, 6.905, 0.16});
  draw->Cylinder(Frame{}, 0.02, {x0, 6.905, 0.66}, {x1, 6.905, 0.66});
}

inline void DrawWindowWall(Drawing* draw) {
  const double sill = 0.9, top = 2.4, width = 2.1, y = kWidth, deep = kWidth + 0.18;
  draw->Use("wall");
  WallPart(draw, y, 0, 0, kLength, sill);
  WallPart(draw, y, 0, top, kLength, kHeight);
  double end = 0;
  for (int i = 0; i < 4; ++i) {
    const double x0 = 0.6 + 2.6 * i, x1 = x0 + width;
    draw->Use("wall");
    WallPart(draw, y, end, sill, x0, top);
    end = x1;
    draw->Polygon(Frame{}, {{x0, y, sill}, {x0, deep, sill}, {x0, deep, top}, {x0, y, top}});
    draw->Polygon(Frame{}, {{x1, y, sill}, {x1, deep, sill}, {x1, deep, top}, {x1, y, top}});
    draw->Polygon(Frame{}, {{x0, y, top}, {x1, y, top}, {x1, deep, top}, {x0, deep, top}});
    draw->Use("oak");
    draw->Box(Frame{}, {x0 - 0.04, y - 0.06, sill - 0.03}, {x1 + 0.04, deep, sill});
    draw->Use("grey_metal");
    for (const double x : {x0, x0 + width / 2 - 0.02, x1 - 0.04}) {
      draw->Box(Frame{}, {x, deep - 0.06, sill}, {x + 0.04, deep, top});
    }
    draw->Box(Frame{}, {x0, deep - 0.06, top - 0.04}, {x1, deep, top});
    draw->Use("glass");
    WallPart(draw, deep - 0.03, x0, sill, x1, top);
    DrawBlind(draw, x0, x1, i == 1 ? 1.62 : sill + 0.03, top);
    DrawRadiator(draw, x0 + 0.2, x1 - 0.2);
  }
  draw->Use("wall");
  WallPart(draw, y, end, sill, kLength, top);
  draw->Use("evening");
  WallPart(draw, y + 0.6, -1, 0, kLength + 1, 3);
}

inline void DrawDoor(Drawing* draw, double x) {
  const Frame door = Frame{}.Moved(x, 0, 0);
  draw->Use("oak");
  draw->Box(door, {0, 0, 0.01}, {0.95, 0.03, 2.1});
  draw->Use("white_metal");
  draw->Box(door, {-0.08, 0, 0}, {0, 0.05, 2.18});
  draw->Box(door, {0.95, 0, 0}, {1.03, 0.05, 2.18});
  draw->Box(door, {0, 0, 2.1}, {0.95, 0.05, 2.18});
  draw->Use("chrome");
  draw->Tube(door, {{0.07, 0.03, 1.02}, {0.07, 0.08, 1.02}, {0.1, 0.09, 1.02}, {0.2, 0.09, 1.02}},
             0.01, 10);
  draw->Disc(door, 0.028, {0.07, 0.031, 1.02}, {0, 1, 0});
  draw->Sphere(door, 0.012, {0.07, 0.034, 0.93});
  for (const double z : {0.3, 1.05, 1.8}) {
    draw->Cylinder(door, 0.01, {0.945, 0.036, z}, {0.945, 0.036, z + 0.1});
  }
  draw->Use("green");
  draw->Box(door, {0.3, 0.01, 2.28}, {0.65, 0.05, 2.42});
  // A clock beside it.
  const Frame clock = door.Moved(-0.6, 0, 2.15).Tilted(-90);
  draw->Use("black_plastic");
  draw->Lathe(clock, {{0.17, 0}, {0.17, 0.04}, {0.155, 0.04}, {0.15, 0.025}}, 40);
  draw->Use("paper");
  draw->Disc(clock, 0.152, {0, 0, 0.024}, {0, 0, 1});
  draw->Use("black_plastic");
  for (int hour = 0; hour < 12; ++hour) {
    draw->Box(clock.Turned(30 * hour), {0.12, -0.004, 0.025}, {0.142, 0.004, 0.028});
  }
  draw->Box(clock.Turned(60), {-0.015, -0.005, 0.029}, {0.085, 0.005, 0.031});
  draw->Box(clock.Turned(-150), {-0.02, -0.003, 0.032}, {0.125, 0.003, 0.034});
}

inline void DrawEndWalls(Drawing* draw) {
  draw->Use("accent_wall");
  draw->Polygon(
      Frame{},
      {{kLength, 0, 0}, {kLength, kWidth, 0}, {kLength, kWidth, kHeight}, {kLength, 0, kHeight}});
  draw->Use("wall");
  draw->Polygon(Frame{}, {{0, 0, 0}, {0, kWidth, 0}, {0, kWidth, kHeight}, {0, 0, kHeight}});
  WallPart(draw, 0, 0, 0, kLength, kHeight);
  draw->Use("oak");
  draw->Box(Frame{}, {kLength - 0.015, 0, 0}, {kLength, kWidth, 0.09});
  draw->Box(Frame{}, {0, kWidth - 0.015, 0}, {kLength, kWidth, 0.09});
  draw->Box(Frame{}, {0, 0, 0}, {8.3, 0.015, 0.09});
}

// A lamp under the ceiling, 1.25 x 0.65 m, with a louvre; its light stands 4 cm below its edge.
inline void DrawLuminaire(Drawing* draw, double x, double y) {
  const Frame lamp = Frame{}.Moved(x, y, 2.6);
  draw->Use("white_metal");
  draw->Box(lamp, {-0.625, -0.325, 0}, {-0.605, 0.325, 0.088});
  draw->Box(lamp, {0.605, -0.325, 0}, {0.625, 0.325, 0.088});
  draw->Box(lamp, {-0.605, -0.325, 0}, {0.605, -0.305, 0.088});
  draw->Box(lamp, {-0.605, 0.305, 0}, {0.605, 0.325, 0.088});
  for (int i = 1; i < 16; ++i) {
    const double at = -0.605 + 1.21 * i / 16;
    draw->Box(lamp, {at - 0.001, -0.305, 0.005}, {at + 0.001, 0.305, 0.04});
  }
  for (int i = 1; i < 4; ++i) {
    const double at = -0.305 + 0.61 * i / 4;
    draw->Box(lamp, {-0.605, at - 0.002, 0.004}, {0.605, at + 0.002, 0.042});
  }
  draw->Use("lamp");
  draw->Polygon(
      lamp,
      {{-0.605, -0.305, 0.08}, {-0.605, 0.305, 0.08}, {0.605, 0.305, 0.08}, {0.605, -0.305, 0.08}});
}

inline void DrawCeilingThings(Drawing* draw) {
  for (int i = 0; i < 4; ++i) {
    for (const double y : {1.75, 5.25}) DrawLuminaire(draw, 1.5 + 2.65 * i, y);
  }
  // Small round lamps before the board and the shelves.
  for (int i = 0; i < 6; ++i) {
    const Frame lamp = i < 3 ? Frame{}.Moved(10.2, 1.75 + 1.75 * i, 2.66)
                             : Frame{}.Moved(5.1 + 1.2 * (i - 3), 0.8, 2.66);
    draw->Use("chrome");
    draw->Lathe(lamp, {{0.06, 0.03}, {0.075, 0}, {0.095, 0}, {0.1, 0.02}, {0.1, 0.04}}, 24);
    draw->Use("lamp");
    draw->Disc(lamp, 0.062, {0, 0, 0.029}, {0, 0, -1});
  }
  const Frame projector = Frame{}.Moved(7.4, 3.5, 2.3);
  draw->Use("white_metal");
  draw->Cylinder(projector, 0.02, {0, 0, 0.1}, {0, 0, 0.4});
  draw->Cushion(projector.Moved(0, 0, 0.03), {0.19, 0.16, 0.07}, 0.25, 8, 32);
  draw->Use("black_plastic");
  draw->Tube(projector, {{0.17, 0.06, 0.03}, {0.23, 0.06, 0.03}}, 0.035, 16);
}

}  // namespace room
