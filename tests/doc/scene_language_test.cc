// doc/scene_language.md is the manual of the whole language: every keyword has a row, whose files,
// test and pictures exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "rayshade/scene/keywords.h"

namespace rayshade {
namespace {

namespace fs = std::filesystem;

std::string Text(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

const char kManual[] = "doc/scene_language.md";

struct Row {
  std::string files, test;
};

// The rows of the last table, by keyword.
std::map<std::string, Row> Rows() {
  std::map<std::string, Row> rows;
  const std::string manual = Text(kManual);
  const size_t at = manual.find("## Every keyword");
  if (at == std::string::npos) return rows;
  std::istringstream lines(manual.substr(at));
  const std::regex row("\\| `([a-z]+)` \\| ([^|]+) \\| ([^|]+) \\| `([^|]+)` \\|");
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, row)) rows[match[1]] = {match[3], match[4]};
  }
  return rows;
}

TEST(SceneLanguageManual, HasARowForEveryKeywordAndNoOther) {
  const std::map<std::string, Row> rows = Rows();
  for (const Keyword& keyword : Keywords()) {
    EXPECT_TRUE(rows.contains(std::string(keyword.text))) << keyword.text;
  }
  EXPECT_EQ(rows.size(), Keywords().size());
}

TEST(SceneLanguageManual, NamesFilesThatExist) {
  const std::regex file("`([a-z_/.]+)`");
  for (const auto& [keyword, row] : Rows()) {
    auto at = std::sregex_iterator(row.files.begin(), row.files.end(), file);
    EXPECT_NE(at, std::sregex_iterator()) << keyword;
    for (; at != std::sregex_iterator(); ++at) {
      EXPECT_TRUE(fs::exists("rayshade/" + (*at)[1].str())) << keyword << ": " << (*at)[1];
    }
  }
}

TEST(SceneLanguageManual, NamesTestsThatExist) {
  std::string tests;
  for (const auto& entry : fs::recursive_directory_iterator("tests")) {
    if (entry.path().extension() == ".cc") tests += Text(entry.path());
  }
  for (const auto& [keyword, row] : Rows()) {
    std::string head = "(" + row.test;
    head.replace(head.find('.'), 1, ", ");
    EXPECT_NE(tests.find(head), std::string::npos) << keyword << ": " << row.test;
  }
}

TEST(SceneLanguageManual, ShowsEveryPictureOfTheGallery) {
  const std::string manual = Text(kManual);
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator("scenes/gallery")) {
    if (entry.path().extension() != ".ray") continue;
    ++pictures;
    const std::string picture = "gallery/" + entry.path().stem().string() + ".png";
    EXPECT_NE(manual.find("(" + picture + ")"), std::string::npos) << picture;
    EXPECT_TRUE(fs::exists("doc/" + picture)) << picture;
  }
  EXPECT_GT(pictures, 70);
}

}  // namespace
}  // namespace rayshade
