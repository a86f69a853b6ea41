// Objects by their ranks.
#include "parallel/rank_index.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

class RankIndexTest : public testing::Test {
 protected:
  RankIndexTest() : scene_(SceneSpec{}, 0) {
    Placement placement;
    placement.levels.resize(1);
    placement.Finish();
    scene_.spec.placements = {placement};
  }
  void ExpectFound(const std::vector<Rank>& ranks) {
    ObjectSet set(&scene_);
    for (size_t i = 0; i < ranks.size(); ++i) {
      set.Add(SphereSpec{.1, {static_cast<double>(i), 0, 0}}, 0, ranks[i]);
    }
    set.Build();
    const RankIndex index(&set);
    for (const Rank rank : ranks) {
      const Hit hit = index.Find(2.5, rank);
      ASSERT_EQ(hit.set, &set) << rank;
      EXPECT_EQ(set.rank_of(hit.object), rank);
      EXPECT_EQ(hit.rank, rank);
      EXPECT_EQ(hit.distance, 2.5);
    }
    for (const Rank rank : {Rank{3}, Rank{70001}, Rank{4000000000u}, kNoRank - 1}) {
      EXPECT_EQ(index.Find(1, rank).set, nullptr) << rank;
    }
  }
  Scene scene_;
};

TEST_F(RankIndexTest, FindsRanksInARow) {
  std::vector<Rank> ranks;
  for (Rank r = 1000; r < 3000; ++r) ranks.push_back(r);
  ExpectFound(ranks);
}

TEST_F(RankIndexTest, FindsRanksFarApart) {
  ExpectFound({0, 1, 2, 5, 70000, 70002, 1u << 31, 3999999999u});
}

TEST_F(RankIndexTest, AnEmptySetHasNone) { ExpectFound({}); }

}  // namespace
}  // namespace rayshade::parallel
