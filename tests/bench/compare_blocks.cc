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

double BlockMean(const ImageData& image, int x, int y, int c, int block) {
  double sum = 0;
  for (int v = y * block; v < (y + 1) * block; ++v) {
    for (int u = x * block; u < (x + 1) * block; ++u) sum += Value(image, u, v, c);
  }
  return sum / (double(block) * block);
}

int Compare(const ImageData& picture, const ImageData& reference) {
  const int block = reference.width / picture.width;
  if (block * picture.width != reference.width || block * picture.height != reference.height) {
    std::fprintf(stderr, "compare_blocks: the sizes do not fit\n");
    return 1;
  }
  double squares = 0;
  int off = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      double worst = 0;
      for (int c = 0; c < 3; ++c) {
        const double apart = Value(picture, x, y, c) - BlockMean(reference, x, y, c, block);
        squares += apart * apart;
        worst = std::max(worst, std::fabs(apart));
      }
      off += worst > 2;
    }
  }
  const double pixels = double(picture.width) * picture.height;
  std::printf("%.4f %.3f\n", std::sqrt(squares / (3 * pixels)), 100 * off / pixels);
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
    return rayshade::bench::Compare(rayshade::ReadPng(argv[1]), rayshade::ReadPng(argv[2]));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "compare_blocks: %s\n", e.what());
    return 1;
  }
}
