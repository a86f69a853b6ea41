// Numbers, expressions and variables of the language; the table of [rayshade4/1 s.14.3].
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

// What `print` writes after the definitions a = 5, without the message that nothing is rendered.
std::string Printed(const std::string& value) {
  const std::string messages = ReadText("define a 5 print " + value + "\n").messages;
  return messages.substr(0, messages.find("\nrs: Fatal error: Nothing"));
}

struct Case {
  const char* input;
  const char* printed;
};

TEST(Expressions, HaveTheValuesOfTheSpecification) {
  const std::vector<Case> cases{{"(2+3*4)", "14.000000"},
                                {"(2^3^2)", "512.000000"},
                                {"(-2^2)", "-4.000000"},
                                {"(2^-1*3)", "1.500000"},
                                {"(2^-2^2)", "0.062500"},
                                {"(7%3)", "1.000000"},
                                {"(-7%3)", "-1.000000"},
                                {"(7.9%2.9)", "1.000000"},
                                {"(8-3-2)", "3.000000"},
                                {"(8/4/2)", "1.000000"},
                                {"(10%4*3)", "6.000000"},
                                {"(2*3%4)", "2.000000"},
                                {"(7%2%2)", "1.000000"},
                                {"(--5)", "5.000000"},
                                {"(- - 5)", "5.000000"},
                                {"- 5", "-5.000000"},
                                {"-.5e1", "-5.000000"},
                                {"(a+1)", "6.000000"},
                                {"(a -1)", "4.000000"},
                                {"(a/2)", "2.500000"},
                                {"(2*a)", "10.000000"},
                                {"(2/ a)", "0.400000"},
                                {"(2*-3)", "-6.000000"},
                                {"(cos(1,2))", "0.540302"},
                                {"(hypot(3,4,5,6,7))", "5.000000"},
                                {"(pi)", "3.141592"},
                                {"(dtor)", "0.017453"},
                                {"(rtod)", "57.295780"},
                                {"(1/0)", "inf"},
                                {"(sqrt(hypot(3,4)*5))", "5.000000"},
                                {"(-0)", "-0.000000"},
                                {"(1e2)", "100.000000"},
                                {".5", "0.500000"},
                                {"5.", "5.000000"},
                                {"1.e2", "100.000000"},
                                {"+ 5", "5.000000"},
                                {"(+5)", "5.000000"},
                                {"12345678901234567890", "12345678901234567168.000000"},
                                {"1e400", "inf"}};
  for (const Case& c : cases) EXPECT_EQ(Printed(c.input), c.printed) << c.input;
}

TEST(Expressions, NumbersReadAsTheNearestDouble) {
  for (const char* number :
       {"0.1", "0.272166", "-0.0555556", "123456789.123456", "1.7976931348623157e308", "4.9e-324",
        "0.30000000000000004", "9007199254740993", "999999999999999.9"}) {
    const Reading r = ReadText(std::string("fov ") + number + " sphere 1 0 0 0");
    ASSERT_EQ(r.sink.settings.size(), 1u) << number << r.messages;
    EXPECT_EQ(r.sink.settings[0].hfov, std::strtod(number, nullptr)) << number;
  }
}

TEST(Expressions, NumbersOfEachLengthReadAsTheNearestDouble) {
  const std::string digits = "90817263549081726354";
  for (size_t whole = 0; whole <= 10; ++whole) {
    for (size_t fraction = 0; fraction <= 18; ++fraction) {
      if (whole + fraction == 0) continue;
      const std::string number = digits.substr(whole, whole) + "." + digits.substr(1, fraction);
      for (const std::string& text :
           {"fov " + number + " sphere 1 0 0 0", "sphere 1 0 0 0 fov " + number + "\n"}) {
        const Reading r = ReadText(text);
        ASSERT_EQ(r.sink.settings.size(), 1u) << number << r.messages;
        EXPECT_EQ(r.sink.settings[0].hfov, std::strtod(number.c_str(), nullptr)) << number;
      }
    }
  }
}

TEST(Expressions, MistakesHaveTheOriginalsWordsAndStatus) {
  struct Mistake {
    const char* input;
    const char* message;
    int status;
  };
  const std::vector<Mistake> mistakes{
      {"print (a-1)", "rs: Fatal error: stdin, line 1: Symbol a-1 not defined!", 2},
      {"print (rotd)", "Symbol rotd not defined!", 2},
      {"print (2/a)", "rs: Error: stdin: line 1: syntax error", 1},
      {"print (a/a)", "syntax error", 1},
      {"print (hypot(1,2,3,4,5,6))", "syntax error", 1},
      {"print (1 % 0)", "Remainder of a division by zero.", 1},
      {"print (hypot(3))", "Too few arguments for hypot.", 1},
      {"print (time)", "Illegal expression use.", 2},
      {"print (time*0)", "Illegal expression use.", 2},
      {"print (linear(0,1,2,3))", "Illegal expression use.", 2},
      {"print (cos)", "Symbol cos is not a float expression!", 2},
      {"print (pi(1))", "Symbol pi is not a built in function!", 2},
      {"print cos(0)", "syntax error", 1},
      {"print -(3)", "syntax error", 1},
      {"print - -3", "syntax error", 1},
      {"print a", "syntax error", 1},
      {"define pi 3", "rs: Error: stdin, line 1: Symbol pi redefined.", 1},
      {"define a 5", "Symbol a redefined.", 1},
      {"define sphere 4", "syntax error", 1}};
  for (const Mistake& m : mistakes) {
    const Reading r = ReadText(std::string("define a 5 ") + m.input + "\nsphere 1 0 0 0\n");
    EXPECT_NE(r.messages.find(m.message), std::string::npos) << m.input << ": " << r.messages;
    EXPECT_EQ(r.status, m.status) << m.input;
    EXPECT_FALSE(r.good);
    EXPECT_TRUE(r.sink.settings.empty());
  }
}

TEST(Expressions, OutsideOfParenthesesASignEndsTheNumberBefore) {
  const Reading r = ReadText("sphere 1 2-3+4");
  ASSERT_EQ(r.sink.geoms.size(), 1u) << r.messages;
  EXPECT_EQ(std::get<SphereSpec>(r.sink.geoms[0]).center, (Vector{2, -3, 4}));
}

TEST(Expressions, NamesMayHoldDotsAndDashes) {
  EXPECT_EQ(Printed("1 define x.y-z_1 4 print (x.y-z_1)"), "1.000000\n4.000000");
}

TEST(Expressions, VariablesThatVaryDoSoWhereTheyAreUsed) {
  const Reading r =
      ReadText("define v (time*3) define w (v+1) sphere 1 0 0 0 translate (w) 0 0 translate 1 0 0");
  ASSERT_EQ(r.sink.attributes.size(), 1u) << r.messages;
  const TransformChain& chain = r.sink.attributes[0].transforms;
  EXPECT_EQ(chain.size(), 2u);
  EXPECT_EQ(chain.Whole({0, 2}).Point({0, 0, 0}).x, 8);
}

TEST(Expressions, GrowNoFurtherThanSense) {
  std::string text = "define a0 (time)\n";
  for (int i = 0; i < 40; ++i) {
    const std::string a = "a" + std::to_string(i);
    text += "define a" + std::to_string(i + 1) + " (" + a + "*" + a + ")\n";
  }
  EXPECT_NE(ReadText(text).messages.find("Expression too long."), std::string::npos);
}

TEST(Expressions, DeeplyNestedOnesEndInAnErrorAndNoCrash) {
  const std::string open(20000, '('), close(20000, ')');
  const Reading r = ReadText("print " + open + "1" + close + "\nsphere 1 0 0 0");
  EXPECT_FALSE(r.good);
  EXPECT_EQ(Printed(std::string(1000, '(') + "1" + std::string(1000, ')')), "1.000000");
}

}  // namespace
}  // namespace rayshade
