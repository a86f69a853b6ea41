// Mistakes: what is said, and how reading goes on [rayshade4/1 s.2, 13].
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

using Calls = std::vector<std::string>;

long Lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(Recovery, AFileWithTenMistakesReportsTen) {
  const Reading r = ReadText(
      "shpere 1 0 0 0\n"
      "sphere 1 0 0\n"
      "sphere nosuch 1 0 0 0\n"
      "sphere 1 0 0 0 5\n"
      "sphere (x) 0 0 0\n"
      "light 1 directional 0 0 0\n"
      "object nothing\n"
      "list define a 3 sphere 1 0 0 0 end\n"
      "sphere 1 0 0 0 scale 1 0 1\n"
      "box 0 0 0 (time) 1 1\n"
      "sphere 1 0 0 0\n");
  EXPECT_EQ(r.messages,
            "rs: Error: stdin: line 1: syntax error\n"
            "rs: Error: stdin: line 3: syntax error\n"
            "rs: Fatal error: stdin, line 3: Undefined surface \"nosuch\".\n"
            "rs: Error: stdin: line 4: syntax error\n"
            "rs: Fatal error: stdin, line 5: Symbol x not defined!\n"
            "rs: Error: stdin, line 6: Invalid directional light.\n"
            "rs: Fatal error: stdin, line 8: There is no object named \"nothing\".\n"
            "rs: Error: stdin: line 8: syntax error\n"
            "rs: Fatal error: stdin, line 9: Degenerate scale 1 0 1\n"
            "rs: Fatal error: stdin, line 10: Illegal expression use.\n");
  EXPECT_FALSE(r.good);
  EXPECT_EQ(r.status, 1) << "that of the first: there the original stopped";
}

TEST(Recovery, OneMistakeInAnItemIsSaidOnce) {
  EXPECT_EQ(ReadText("surface A difuse 1 1 1\nsphere A 1 0 0 0\n").messages,
            "rs: Fatal error: stdin, line 1: Undefined surface \"difuse\".\n");
}

TEST(Recovery, TheStatusIsThatOfTheFirstError) {
  EXPECT_EQ(ReadText("sphere nosuch 1 0 0 0\nsphere 1 1\n").status, 2);
  EXPECT_EQ(ReadText("sphere 1 1\nsphere nosuch 1 0 0 0\n").status, 1);
}

TEST(Recovery, AfterAnErrorNothingMoreIsPlacedAndNoSettingsArrive) {
  const Reading r = ReadText("sphere 1 0 0 0\nsphre\nbox 0 0 0 1 1 1\n");
  EXPECT_EQ(r.sink.calls, (Calls{"sphere"}));
  EXPECT_TRUE(r.sink.settings.empty());
}

TEST(Recovery, GoesOnInsideOfAnAggregate) {
  const Reading r = ReadText(
      "union sphere 1 0 0 0 name X list sphere 1 0 z end\nbox 0 0 0 1 1 end\nsphere 2 2\nend\n"
      "sphere 1 0 0 0\n");
  EXPECT_EQ(Lines(r.messages), 3) << r.messages;
}

TEST(Recovery, AnUnknownNameIsReportedOnce) {
  const Reading r = ReadText(
      "sphere A 1 0 0 0\nsphere A 1 0 0 0\nobject B\nobject B\nsphere (c) 0 0 0\nsphere (c) 0 0 "
      "0\n");
  EXPECT_EQ(Lines(r.messages), 3) << r.messages;
}

TEST(Recovery, AStrayEndAndAMissingOneAreSyntaxErrors) {
  EXPECT_EQ(ReadText("sphere 1 0 0 0\nend\n").messages, "rs: Error: stdin: line 2: syntax error\n");
  EXPECT_EQ(ReadText("list\n\tsphere 1 0 0 0\n").messages,
            "rs: Error: stdin: line 3: syntax error\n");
}

TEST(Recovery, GivesUpAfterAHundred) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "sphere 1\n";
  const Reading r = ReadText(text);
  EXPECT_EQ(Lines(r.messages), 101);
  EXPECT_NE(r.messages.find("Too many errors"), std::string::npos);
}

TEST(Recovery, StrangeBytesAreSyntaxErrors) {
  for (const std::string& text :
       {std::string("sphere 1 0 0 0 \0 box", 20), std::string("sph\xe9re 1 0 0 0"),
        std::string("sphere 1 0 0 0 # note"), std::string("outfile _x"), std::string("outfile 3x"),
        std::string("outfile a/"), std::string("outfile a/1b"), std::string("outfile \"a\"")}) {
    EXPECT_NE(ReadText(text + " sphere 1 0 0 0").messages.find("syntax error"), std::string::npos)
        << text;
  }
}

TEST(Recovery, LineEndsOfOtherSystemsAreWhiteSpace) {
  const Reading r =
      ReadText("sphere 1 0 0\r\n0\r\n#line 7 \"a.inc\"\r\nbox\f0 0 0 1 1 1\rnosuch\r\n");
  EXPECT_EQ(r.sink.calls, (Calls{"sphere", "box"}));
  EXPECT_EQ(r.messages, "rs: Error: a.inc: line 7: syntax error\n");
}

TEST(Recovery, TokensThatEndTooSoonAreTakenAsFarAsTheyGo) {
  const auto printed = [](const std::string& text) {
    return ReadText(text + " sphere 1 0 0 0").messages;
  };
  // A number, and the word that begins with its exponent's letter.
  EXPECT_EQ(printed("print 1eyep 0 0 0 print .5eyep 1 1 1 print -2.eyep 1 1 1"),
            "1.000000\n0.500000\n-2.000000\n");
  EXPECT_EQ(printed("define e 1 print (1e+e)"), "rs: Error: stdin: line 1: syntax error\n");
  // A path goes as far as its last name.
  for (const char* path : {"a/b/", "/a/./", "//a/b/..", "./a/", "../a/."}) {
    EXPECT_EQ(printed(std::string("outfile ") + path), "rs: Error: stdin: line 1: syntax error\n");
  }
  EXPECT_EQ(ReadText("print (6/ 2) print (8 /2) sphere 1 0 0 0").messages, "3.000000\n4.000000\n");
  EXPECT_EQ(ReadText("define a 6 print (a/ 2) sphere 1 0 0 0").messages, "3.000000\n");
  EXPECT_EQ(ReadText("sphere 1 0 0 -.5 outfile ..sphere 1 0 0 0").status, 1);
  EXPECT_EQ(ReadText("outfile /tmp/./x/../a.b sphere 1 0 0 +.5").sink.settings.at(0).output,
            "/tmp/./x/../a.b");
}

TEST(Recovery, AnUnterminatedCommentIsAnError) {
  const Reading r = ReadText("sphere 1 0 0 0 /* and\nso on");
  EXPECT_EQ(r.messages, "rs: Error: stdin, line 2: Unterminated comment.\n");
  EXPECT_EQ(r.status, 1);
}

TEST(Recovery, CommentsEndAtTheFirstChance) {
  for (const char* comment : {"/**/", "/***/", "/* a * b ** / c **/", "/* /* */", "/*\n*\n*/"}) {
    EXPECT_EQ(ReadText(std::string("sphere 1 0 0") + comment + "0").sink.calls, (Calls{"sphere"}))
        << comment;
  }
}

TEST(Recovery, WhatTheOriginalCrashedOnIsDroppedWithAWarning) {
  const Reading list = ReadText("list end scale 2 2 2\nsphere 1 0 0 0\n");
  EXPECT_EQ(list.messages, "rs: Warning: stdin, line 1: Null object defined.\n");
  EXPECT_EQ(list.sink.calls, (Calls{"list", "end of nothing x1", "sphere"}));
  const Reading grid =
      ReadText("grid 0 1 1 sphere 1 0 0 0 list box 0 0 0 1 1 1 end end\nsphere 1 0 0 0\n");
  EXPECT_EQ(grid.messages, "rs: Warning: stdin, line 1: Invalid grid specification.\n");
  EXPECT_EQ(grid.sink.calls, (Calls{"sphere"}));
  EXPECT_TRUE(list.good && grid.good);
  EXPECT_EQ(ReadText("report 0 sphere 1 0 0 0").sink.settings.at(0).report_frequency, 1);
}

TEST(Recovery, CsgOfOtherThanTwoIsDroppedWithAWarning) {
  const std::string ball = "sphere 1 0 0 0 ";
  const Reading three = ReadText("union " + ball + ball + ball + "end " + ball);
  EXPECT_EQ(three.messages,
            "rs: Warning: stdin, line 1: Currently, CSG only handles two objects.\n");
  const Reading one = ReadText("intersect " + ball + "end " + ball);
  EXPECT_EQ(one.messages, "rs: Warning: stdin, line 1: CSG needs at least two objects.\n");
  EXPECT_TRUE(three.good && one.good);
  // What names such an object names none.
  const Reading named = ReadText("name X union " + ball + "end object X " + ball);
  EXPECT_NE(named.messages.find("There is no object named \"X\"."), std::string::npos);
  EXPECT_EQ(named.status, 2);
}

TEST(Recovery, OpenOperandsAreAdvisedOnceAndNotWithQuiet) {
  const std::string open = "union sphere 1 0 0 0 plane 0 0 0 0 0 1 end\n";
  EXPECT_EQ(ReadText(open + open).messages,
            "rs: Warning: stdin, line 1: Performing CSG with non-closed object(s).\n");
  EXPECT_EQ(ReadText("report quiet " + open).messages, "");
  EXPECT_EQ(ReadText("union sphere 1 0 0 0 list plane 0 0 0 0 0 1 end end").messages, "");
}

TEST(Recovery, AnEmptySceneSaysSo) {
  EXPECT_EQ(ReadText("").messages, "rs: Fatal error: Nothing to be rendered.\n");
  EXPECT_EQ(ReadText("name X sphere 1 0 0 0").status, 2);
}

TEST(Recovery, DegenerateRotationsWarnAndSingularOnesAreFatal) {
  const Reading r = ReadText("sphere 1 0 0 0 rotate 0 0 0 10\n");
  EXPECT_EQ(r.messages, "rs: Warning: stdin, line 1: Degenerate rotation axis.\n");
  EXPECT_NEAR(r.sink.attributes.at(0).transforms.Whole({}).matrix.m[1][1], .9848077, 1e-6);
  EXPECT_EQ(ReadText("sphere 1 0 0 0 rotate 0 0 0 90").status, 2);
  EXPECT_NE(
      ReadText("sphere 1 0 0 0 transform 0 0 0 0 1 0 0 0 1").messages.find("Singular matrix."),
      std::string::npos);
}

}  // namespace
}  // namespace rayshade
