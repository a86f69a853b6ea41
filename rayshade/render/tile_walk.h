// A rectangle of pixels cut into tiles of at most `most` pixels, as square as possible, visited in
// rows of tiles; and the pixels of a tile in blocks: the rays of neighbours on the list should be
// neighbours in the picture, in both directions, since they are traced together.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rayshade {

struct Tile {
  int x = 0, y = 0, width = 0, height = 0;
};

// A block is as wide and as high as this: its rays are a bundle (accel/bundles.inl).
inline constexpr int kBlockPixels = 8;

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
      height_ = std::min(bottom_ - y_, WholeBlocks(static_cast<int>(std::sqrt(double(most)))));
    }
    // A row of tiles keeps its height; the few rows left at the bottom are cut wider instead.
    const int wide = WholeBlocks(static_cast<int>(std::min<size_t>(most / height_, width_)));
    const Tile tile{x_, y_, std::min(wide, width_ - x_), height_};
    x_ += tile.width;
    if (x_ >= width_) {
      x_ = 0;
      y_ += height_;
    }
    return tile;
  }

 private:
  // At least one pixel.
  static int WholeBlocks(int pixels) {
    return pixels < kBlockPixels ? std::max(1, pixels) : pixels / kBlockPixels * kBlockPixels;
  }

  int width_, bottom_;
  int x_ = 0, y_ = 0, height_ = 1;
};

// The pixels of a tile, block by block, each block row by row.
class TilePixels {
 public:
  TilePixels() = default;  // of no tile
  explicit TilePixels(const Tile& tile) : tile_(tile), left_(size_t(tile.width) * tile.height) {
    BeginBlock(tile.x, tile.y);
  }

  size_t left() const { return left_; }
  bool done() const { return left_ == 0; }
  // REQUIRES: !done().
  int x() const { return x_; }
  int y() const { return y_; }
  void Next() {
    --left_;
    if (++x_ < block_.x + block_.width) return;
    x_ = block_.x;
    if (++y_ < block_.y + block_.height) return;
    const bool row_ends = block_.x + block_.width == tile_.x + tile_.width;
    row_ends ? BeginBlock(tile_.x, block_.y + block_.height)
             : BeginBlock(block_.x + block_.width, block_.y);
  }

 private:
  void BeginBlock(int x, int y) {
    block_ = {x, y, std::min(kBlockPixels, tile_.x + tile_.width - x),
              std::min(kBlockPixels, tile_.y + tile_.height - y)};
    x_ = x;
    y_ = y;
  }

  Tile tile_, block_;
  size_t left_ = 0;
  int x_ = 0, y_ = 0;
};

}  // namespace rayshade
