// A rectangle of pixels cut into tiles of at most `most` pixels, as square as possible, visited in
// rows of tiles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rayshade {

struct Tile {
  int x = 0, y = 0, width = 0, height = 0;
};

class TileWalk {
 public:
  // Rows [top, bottom) of a picture `width` wide.
  TileWalk(int width, int top, int bottom) : width_(width), bottom_(bottom), y_(top) {}

  bool done() const { return y_ >= bottom_; }
  // First row that no tile has reached so far.
  int rows_begun() const { return done() ? bottom_ : y_ + (x_ > 0 ? height_ : 0); }

  // REQUIRES: !done(), most >= 1.
  Tile Next(size_t most) {
    if (x_ == 0) {
      height_ = std::min(bottom_ - y_, std::max(1, static_cast<int>(std::sqrt(double(most)))));
    }
    // A row of tiles keeps its height; the few rows left at the bottom are cut wider instead.
    const int wide =
        static_cast<int>(std::min<size_t>(std::max<size_t>(1, most / height_), width_));
    const Tile tile{x_, y_, std::min(wide, width_ - x_), height_};
    x_ += tile.width;
    if (x_ >= width_) {
      x_ = 0;
      y_ += height_;
    }
    return tile;
  }

 private:
  int width_, bottom_;
  int x_ = 0, y_ = 0, height_ = 1;
};

}  // namespace rayshade
