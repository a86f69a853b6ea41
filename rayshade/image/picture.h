// The picture as it is gathered: unclamped colours with alpha, row 0 on top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rayshade/common/color.h"
#include "rayshade/common/zero_pages.h"

namespace rayshade {

struct PixelValue {
  Color color;
  double alpha = 0;
  bool full = false;  // supersampled, for the sample map
};

class Picture {
 public:
  Picture(int width, int height)
      : width_(width), height_(height), pixels_(std::size_t(width) * height) {}

  int width() const { return width_; }
  int height() const { return height_; }
  PixelValue& at(int x, int y) { return pixels_[std::size_t(y) * width_ + x]; }
  const PixelValue& at(int x, int y) const { return pixels_[std::size_t(y) * width_ + x]; }

 private:
  int width_, height_;
  std::vector<PixelValue, ZeroPages<PixelValue>> pixels_;
};

}  // namespace rayshade
