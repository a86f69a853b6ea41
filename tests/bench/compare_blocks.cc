// Error of a picture of some program against a larger one of the same view, whose pixels are
// averaged in blocks:
//
//   compare_blocks PICTURE REFERENCE   prints the root mean square difference (1/255) and the
//   percent of pixels off by more
//                                      than 2/255 in a channel; PNGs, the second one's sides
//                                      multiples of the first one's
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "rayshade/image/png.h"

namespace rayshade::bench {
namespace {

double Value(const ImageData& image, int x, int y, int c) {
  const int channel = image.channels == 1 ? 0 : c;
  return image.color[(size_t(y) * image.width + x) * image.channels + channel];
}

// The mean of the block whose low corner is (left, top).
double BlockMean(const ImageData& image, int left, int top, int c, int block) {
  double sum = 0;
  for (int v = top; v < top + block; ++v) {
    for (int u = left; u < left + block; ++u) sum += Value(image, u, v, c);
  }
  return sum / (double(block) * block);
}

struct Error {
  double squares = 0;
  double off = 0;  // pixels
};

// Without the border, whose blocks may reach beyond the reference.
Error Compare(const ImageData& picture, const ImageData& reference, int shift_x, int shift_y) {
  const int block = reference.width / picture.width;
  Error error;
  for (int y = 1; y < picture.height - 1; ++y) {
    for (int x = 1; x < picture.width - 1; ++x) {
      double worst = 0;
      for (int c = 0; c < 3; ++c) {
        const double apart = Value(picture, x, y, c) - BlockMean(reference, x * block + shift_x,
                                                                 y * block + shift_y, c, block);
        error.squares += apart * apart;
        worst = std::max(worst, std::fabs(apart));
      }
      error.off += worst > 2;
    }
  }
  return error;
}

int CompareAll(const ImageData& picture, const ImageData& reference) {
  const int block = reference.width / picture.width;
  if (block * picture.width != reference.width || block * picture.height != reference.height) {
    std::fprintf(stderr, "compare_blocks: the sizes do not fit\n");
    return 1;
  }
  // Programs differ in whether a pixel lies around its coordinates or behind them.
  Error best;
  best.squares = 1e300;
  for (const int shift_x : {-block / 2, 0, block / 2}) {
    for (const int shift_y : {-block / 2, 0, block / 2}) {
      const Error error = Compare(picture, reference, shift_x, shift_y);
      if (error.squares < best.squares) best = error;
    }
  }
  const double pixels = double(picture.width - 2) * (picture.height - 2);
  std::printf("%.4f %.3f\n", std::sqrt(best.squares / (3 * pixels)), 100 * best.off / pixels);
  return 0;
}

}  // namespace
}  // namespace rayshade::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: compare_blocks PICTURE REFERENCE\n");
    return 2;
  }
  try {
    return rayshade::bench::CompareAll(rayshade::ReadPng(argv[1]), rayshade::ReadPng(argv[2]));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "compare_blocks: %s\n", e.what());
    return 1;
  }
}
