// A rectangle of pixels cut into tiles of at most `most` pixels, as square as possible, visited in
// rows of tiles; and the pixels of a tile in blocks and groups: rays that follow each other are
// traced together (accel/bundles.inl), so they should be neighbours in the picture in both
// directions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rayshade {

struct Tile {
  int x = 0, y = 0, width = 0, height = 0;
};

// Pixels of a side of a block, whose rays are a bundle, and of a group, eight of which are one.
inline constexpr int kBlockSide = 8, kGroupWidth = 4, kGroupHeight = 2;

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
    return pixels < kBlockSide ? std::max(1, pixels) : pixels / kBlockSide * kBlockSide;
  }

  int width_, bottom_;
  int x_ = 0, y_ = 0, height_ = 1;
};

// The pixels of a tile: its blocks in rows, each block's groups in rows, each group's pixels in
// rows.
class TilePixels {
 public:
  TilePixels() = default;  // of no tile
  explicit TilePixels(const Tile& tile)
      : tile_(tile),
        block_(First(tile, kBlockSide, kBlockSide)),
        group_(First(block_, kGroupWidth, kGroupHeight)),
        left_(size_t(tile.width) * tile.height),
        x_(tile.x),
        y_(tile.y) {}

  size_t left() const { return left_; }
  bool done() const { return left_ == 0; }
  // REQUIRES: !done().
  int x() const { return x_; }
  int y() const { return y_; }
  // From here to the end of the group's row.
  int run() const { return group_.x + group_.width - x_; }
  void Next() { Skip(1); }
  // REQUIRES: 1 <= count <= run().
  void Skip(int count) {
    left_ -= static_cast<size_t>(count);
    x_ += count;
    if (x_ < group_.x + group_.width) return;
    x_ = group_.x;
    if (++y_ < group_.y + group_.height) return;
    if (!Advance(block_, kGroupWidth, kGroupHeight, &group_)) {
      Advance(tile_, kBlockSide, kBlockSide, &block_);
      group_ = First(block_, kGroupWidth, kGroupHeight);
    }
    x_ = group_.x;
    y_ = group_.y;
  }

 private:
  // The parts of a rectangle, of at most this size, in rows.
  static Tile First(const Tile& whole, int width, int height) {
    return {whole.x, whole.y, std::min(width, whole.width), std::min(height, whole.height)};
  }
  static bool Advance(const Tile& whole, int width, int height, Tile* part) {
    part->x += part->width;
    if (part->x == whole.x + whole.width) {
      part->x = whole.x;
      part->y += part->height;
    }
    part->width = std::min(width, whole.x + whole.width - part->x);
    part->height = std::min(height, whole.y + whole.height - part->y);
    return part->height > 0;
  }

  Tile tile_, block_, group_;
  size_t left_ = 0;
  int x_ = 0, y_ = 0;
};

}  // namespace rayshade
