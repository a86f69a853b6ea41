// Objects on disk: every pass gives the same, and what the sequential scene has.
#include "parallel/object_spool.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>
#include <stdexcept>

#include "rayshade/scene/scene_builder.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

std::vector<SpooledObject> Pass(ObjectSpool* spool, bool geometry) {
  std::vector<SpooledObject> objects;
  spool->Rewind();
  for (SpooledObject o; spool->Next(geometry, &o);) objects.push_back(o);
  return objects;
}

TEST(ObjectSpool, GivesTheSameInEveryPass) {
  ObjectSpool spool;
  ParseText(GlassScene(), &spool);
  spool.Place(0);
  const auto first = Pass(&spool, true), second = Pass(&spool, true), bounds = Pass(&spool, false);
  ASSERT_EQ(first.size(), spool.size());
  ASSERT_EQ(second.size(), first.size());
  ASSERT_EQ(bounds.size(), first.size());
  int unbounded = 0;
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].object.rank, second[i].object.rank);
    EXPECT_EQ(first[i].object.geom.index(), second[i].object.geom.index());
    EXPECT_EQ(first[i].bounds, bounds[i].bounds);
    EXPECT_EQ(first[i].bytes, bounds[i].bytes);
    EXPECT_GT(first[i].bytes, 0u);
    unbounded += !first[i].bounded;
  }
  EXPECT_EQ(unbounded, 1) << "the plane";
}

TEST(ObjectSpool, HasTheObjectsAndRanksOfTheSequentialScene) {
  for (const std::string& text : {Balls(2, 8), InstanceScene(), GlassScene()}) {
    ObjectSpool spool;
    ParseText(text, &spool);
    spool.Place(0);
    SceneBuilder builder;
    ParseText(text, &builder);
    const SceneBuilder::Built built = builder.Build(0);
    std::set<Rank> sequential, spooled;
    for (uint32_t i = 0; i < built.objects->size(); ++i)
      sequential.insert(built.objects->entry(i).rank);
    for (const SpooledObject& o : Pass(&spool, true)) {
      EXPECT_TRUE(spooled.insert(o.object.rank).second) << "a rank twice";
      EXPECT_LT(o.object.placement, spool.scene().placements.size());
    }
    EXPECT_EQ(spooled, sequential);
    EXPECT_EQ(spool.size(), built.objects->size());
  }
}

TEST(ObjectSpool, InstancesOfOneMemberShareItsNumber) {
  ObjectSpool spool;
  ParseText(InstanceScene(), &spool);
  spool.Place(0);
  std::map<uint32_t, int> uses;
  for (const SpooledObject& o : Pass(&spool, true)) ++uses[o.object.member];
  EXPECT_EQ(uses[0], 1) << "the plane is placed once";
  uses.erase(0);
  EXPECT_EQ(uses.size(), 3u) << "cone, cylinder and sphere";
  for (const auto& [member, n] : uses) EXPECT_EQ(n, 30) << member;
}

TEST(ObjectSpool, SaysWhereItCannotWrite) {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", "/nowhere/at/all", 1);
  std::string text;
  try {
    ObjectSpool spool;
  } catch (const std::runtime_error& e) {
    text = e.what();
  }
  if (before == nullptr) {
    unsetenv("TMPDIR");
  } else {
    setenv("TMPDIR", kept.c_str(), 1);
  }
  EXPECT_NE(text.find("/nowhere/at/all"), std::string::npos) << text;
}

}  // namespace
}  // namespace rayshade::parallel
