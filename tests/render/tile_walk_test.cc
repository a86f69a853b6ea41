// Tiles and the order of their pixels.
#include "rayshade/render/tile_walk.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace rayshade {
namespace {

using Pixel = std::pair<int, int>;

std::vector<Pixel> PixelsOf(const Tile& tile) {
  std::vector<Pixel> pixels;
  for (TilePixels p(tile); !p.done(); p.Next()) {
    EXPECT_EQ(p.left(), size_t(tile.width) * tile.height - pixels.size());
    pixels.emplace_back(p.x(), p.y());
  }
  return pixels;
}

TEST(TileWalk, EveryPixelComesOnceInTilesOfAtMostSoMany) {
  for (const size_t most : {1u, 2u, 7u, 64u, 100u, 423u, 1024u}) {
    for (const auto& [width, height] : {Pixel{1, 1}, Pixel{70, 45}, Pixel{33, 8}, Pixel{3, 200}}) {
      std::set<Pixel> seen;
      for (TileWalk walk(width, 2, height + 2); !walk.done();) {
        const Tile tile = walk.Next(most);
        const std::vector<Pixel> pixels = PixelsOf(tile);
        EXPECT_LE(pixels.size(), most);
        seen.insert(pixels.begin(), pixels.end());
        for (const auto& [x, y] : pixels) {
          EXPECT_TRUE(x >= tile.x && x < tile.x + tile.width);
          EXPECT_TRUE(y >= tile.y && y < tile.y + tile.height);
        }
      }
      EXPECT_EQ(seen.size(), size_t(width) * height) << most;
      EXPECT_EQ(*seen.begin(), Pixel(0, 2));
      EXPECT_EQ(*seen.rbegin(), Pixel(width - 1, height + 1));
    }
  }
}

TEST(TileWalk, TilesAreOfWholeBlocksWhereTheyAreLargeEnough) {
  TileWalk walk(100, 0, 100);
  const Tile tile = walk.Next(423);
  EXPECT_EQ(tile.height, 16);
  EXPECT_EQ(tile.width, 24);
}

// So many that follow each other fill rectangles of this size.
void ExpectRectangles(size_t count, int width, int height) {
  const std::vector<Pixel> pixels = PixelsOf({16, 8, 32, 16});
  for (size_t begin = 0; begin < pixels.size(); begin += count) {
    const auto [x, y] = pixels[begin];
    for (size_t i = 0; i < count; ++i) {
      const auto [px, py] = pixels[begin + i];
      EXPECT_TRUE(px >= x && px < x + width && py >= y && py < y + height) << begin + i;
    }
  }
}

TEST(TilePixels, BundlesAreSquaresAndGroupsHaveTwoRows) {
  ExpectRectangles(64, 8, 8);
  ExpectRectangles(8, 4, 2);
}

}  // namespace
}  // namespace rayshade
