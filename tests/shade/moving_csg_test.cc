// Members of CSG that move while the shutter is open: boxes reach over the whole interval, so that
// a ray of any time sees what a still scene of that time shows.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/shade/text_scene.h"

namespace rayshade::test {
namespace {

constexpr double kOpen = 2;  // seconds

// `move` with the time spelled out.
std::string At(std::string text, double time) {
  const std::string number = std::to_string(time);
  for (size_t at; (at = text.find("time")) != std::string::npos;) text.replace(at, 4, number);
  return text;
}

// Rays of many times through the moving scene, beside the same rays through a still one.
void ExpectSeenAtAllTimes(const std::string& objects) {
  const std::string head =
      "light 0 directional 0 -1 0\nsurface a ambient .3 .5 .7\n"
      "surface b ambient .9 .2 .1\n";
  TextScene moving(head + "shutter " + std::to_string(kOpen) + "\n" + objects);
  int hits = 0;
  for (double time = 0; time < kOpen; time += .125) {
    TextScene still(head + At(objects, time));
    for (double x = -3; x <= 12; x += .3125) {
      for (const double z : {-.9, -.3, .2, .6, 1.1}) {
        Ray ray = TextScene::RayTo({x, -20, z}, {.01, 1, .02});
        const RayResult expected = still.Trace(ray);
        ray.time = time;
        const RayResult seen = moving.Trace(ray);
        EXPECT_EQ(expected.hit, seen.hit) << time << " " << x << " " << z;
        EXPECT_NEAR(expected.distance, seen.distance, 1e-9 * expected.distance);
        EXPECT_EQ(expected.color, seen.color);
        hits += seen.hit && time > 1;
      }
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(MovingCsg, AMemberIsSeenWhereItHasGone) {
  ExpectSeenAtAllTimes(
      "union sphere a 1 0 0 0 translate (4*time) 0 0 box b -1 -1 -.2 1 1 .2 end\n");
}

TEST(MovingCsg, AHoleIsWhereItHasGone) {
  ExpectSeenAtAllTimes(
      "difference box a -1 -1 -1 9 1 1 sphere b 1.2 0 -1 0 translate (4*time) 0 0 end\n");
}

TEST(MovingCsg, AnIntersectionOfMembersThatMeetOnlyLater) {
  ExpectSeenAtAllTimes(
      "intersect sphere a 1.5 0 0 0 translate (4*time) 0 0 box b 2 -1 -1 9 1 1 end\n");
}

TEST(MovingCsg, NestedMembersMoveWithTheirListsAndNames) {
  ExpectSeenAtAllTimes(
      "name thing difference list sphere a 1 0 0 0 cylinder b .4 0 0 -1 0 0 1.5 end "
      "translate (2*time) 0 0 box b -.3 -2 -2 .3 0 2 rotate 0 0 1 (45*time) end\n"
      "union object thing translate (2*time) 0 (.2*time) object thing translate -1.5 0 0 end "
      "translate (.5*time) 0 0\n");
}

}  // namespace
}  // namespace rayshade::test
