// doc/messages.md is what the catalogue prints, and the catalogue is whole.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "parallel/message.h"

namespace rayshade::parallel {
namespace {

TEST(Catalogue, IsWhatDocMessagesShows) {
  std::ifstream file("doc/messages.md");
  if (!file) GTEST_SKIP() << "skipped: not started in the root of the repository";
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), CatalogueText()) << "`make doc` prints it anew";
}

TEST(Catalogue, GivesEveryMessageATagOfItsOwn) {
  std::set<int> tags;
  int last = 0;
  ForEachMessage([&]<class Message>() {
    const int tag = static_cast<int>(Message::kTag);
    EXPECT_TRUE(tags.insert(tag).second) << Message::kName;
    EXPECT_GT(tag, last) << Message::kName << " is out of order";
    EXPECT_LT(tag, kTags) << Message::kName;
    EXPECT_STREQ(NameOf(Message::kTag), Message::kName);
    last = tag;
  });
  EXPECT_EQ(tags.size(), static_cast<size_t>(kTags - 1)) << "a tag without a message";
}

TEST(Catalogue, NamesTheSectionOfEveryMessageThatThePaperKnows) {
  int from_paper = 0;
  ForEachMessage([&]<class Message>() {
    EXPECT_STRNE(Message::kMeaning, "") << Message::kName;
    from_paper += std::string(Message::kSection).rfind("RJ s.", 0) == 0;
  });
  EXPECT_EQ(from_paper, kTags - 1 - 4) << "all but ObjectsTaken, Stop, Text and Failure";
}

}  // namespace
}  // namespace rayshade::parallel
