// The scenes of the public reference set: each is read, with the original's messages and statuses.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

std::string ReferenceFolder() {
  const std::string shared = SharedFolder();
  return shared.empty() ? "" : shared + "/reference/public";
}

// The rows of a table, without its headline.
std::vector<std::vector<std::string>> Rows(const std::string& file) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  return rows;
}

void ReplaceAll(std::string* text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text->find(from, at)) != std::string::npos; at += to.size()) {
    text->replace(at, from.size(), to);
  }
}

// A scene of the folder; messages as the original would have written them from inside of it.
Reading ReadScene(const std::string& folder, const std::string& name, const Options& options = {}) {
  Reading r = ReadFile(folder + "/" + name, options);
  ReplaceAll(&r.messages, folder + "/", "");
  return r;
}

TEST(ReferenceScenes, AreAllRead) {
  const std::string folder = ReferenceFolder();
  if (folder.empty()) GTEST_SKIP() << "skipped: no reference scenes";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() != ".ray" || name.starts_with("err-")) continue;
    const Reading r = ReadScene(folder, name);
    EXPECT_TRUE(r.good) << name << ": " << r.messages;
    EXPECT_EQ(r.sink.settings.size(), 1u) << name;
    ++count;
  }
  EXPECT_GT(count, 80);
}

TEST(ReferenceScenes, SayWhatTheOriginalSaid) {
  const std::string folder = ReferenceFolder();
  if (folder.empty()) GTEST_SKIP() << "skipped: no reference scenes";
  for (const std::vector<std::string>& row : Rows(folder + "/messages.tsv")) {
    Options options;
    if (row[0] == "lang-report") options.output = "lang-report.png";
    std::string expected = row[1] + "\n";
    ReplaceAll(&expected, " | ", "\n");
    ReplaceAll(&expected, "rayshade4-ref:", "rs:");
    EXPECT_EQ(ReadScene(folder, row[0] + ".ray", options).messages, expected) << row[0];
  }
}

TEST(ReferenceScenes, MistakesHaveTheOriginalsWordsAndStatus) {
  const std::string folder = ReferenceFolder();
  if (folder.empty()) GTEST_SKIP() << "skipped: no reference scenes";
  for (const std::vector<std::string>& row : Rows(folder + "/errors.tsv")) {
    const std::string& name = row[0];
    // Those that the camera, the command line or the file system refuse, and where the original
    // crashed.
    if (name == "err-view-along-up.ray" || name == "err-bad-window.ray" ||
        name == "err-bad-option.ray" || name == "err-missing-file.ray" ||
        name == "err-missing-include.ray" || name == "err-csg-three.ray") {
      continue;
    }
    std::string expected = row[2] + "\n";
    ReplaceAll(&expected, "rayshade4-ref:", "rs:");
    ReplaceAll(&expected, "Degenerate scale 0 0 0", "Degenerate scale 1 0 1");  // garbage there
    const Reading r = ReadScene(folder, name);
    EXPECT_EQ(r.messages, expected) << name;
    EXPECT_EQ(std::to_string(r.status), row[1]) << name;
  }
}

}  // namespace
}  // namespace rayshade
