// Expressions as programs of a stack machine [rayshade4/1 s.5].
#include "rayshade/common/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace rayshade {
namespace {

using Op = ExpressionOp;

Expression Time() { return Expression({{Op::kTime, 0}}); }
Expression Number(double number) { return Expression(number); }

TEST(Expression, IsFoldedToOneNumberWhereNothingVaries) {
  const Expression sum = Apply(Op::kAdd, {Number(2), Apply(Op::kMultiply, {Number(3), Number(4)})});
  EXPECT_EQ(sum, Expression(14.0));
  EXPECT_EQ(sum.steps().size(), 1u);
}

TEST(Expression, KeepsWhatVariesAndEvaluatesItAtAMoment) {
  const Expression later =
      Apply(Op::kSubtract, {Apply(Op::kMultiply, {Time(), Number(3)}), Number(1)});
  EXPECT_TRUE(later.varies());
  EXPECT_EQ(later.Evaluate({0, 2}), 5);
  EXPECT_EQ(later.Evaluate({7, -1}), -4);
}

TEST(Expression, FrameIsNotTime) {
  const Expression frame({{Op::kFrame, 0}});
  EXPECT_TRUE(frame.varies());
  EXPECT_EQ(frame.Evaluate({3, 99}), 3);
}

TEST(Expression, LinearHoldsItsEndsAndVariesEvenOfNumbers) {
  const Expression ramp = Apply(Op::kLinear, {Number(1), Number(10), Number(2), Number(20)});
  EXPECT_TRUE(ramp.varies());
  EXPECT_EQ(ramp.Evaluate({0, 0}), 10);
  EXPECT_EQ(ramp.Evaluate({0, 1.5}), 15);
  EXPECT_EQ(ramp.Evaluate({0, 3}), 20);
  const Expression step = Apply(Op::kLinear, {Number(1), Number(10), Number(1), Number(20)});
  EXPECT_EQ(step.Evaluate({0, 1}), 10);
}

TEST(Expression, RemainderTruncatesBothAndHasTheSignOfTheDividend) {
  const auto remainder = [](double a, double b) {
    return Apply(Op::kRemainder, {Number(a), Number(b)}).Evaluate({});
  };
  EXPECT_EQ(remainder(7.9, 2.9), 1);
  EXPECT_EQ(remainder(-7, 3), -1);
  EXPECT_EQ(remainder(-2147483648.0, -1), 0);
}

TEST(Expression, RemainderByZeroIsAnErrorAndNoTrap) {
  EXPECT_THROW(Apply(Op::kRemainder, {Number(1), Number(.5)}), std::runtime_error);
  const Expression late = Apply(Op::kRemainder, {Number(5), Time()});
  EXPECT_EQ(late.Evaluate({0, 3}), 2);
  EXPECT_THROW(late.Evaluate({0, 0}), std::runtime_error);
}

TEST(Expression, SurplusArgumentsAreIgnored) {
  EXPECT_EQ(Apply(Op::kHypot, {Number(3), Number(4), Number(9)}), Expression(5.0));
}

TEST(Expression, LongOnesNeedNoMoreThanTheirLength) {
  Expression sum = Time();
  for (int i = 0; i < 500; ++i) sum = Apply(Op::kAdd, {Time(), sum});  // deep to the right
  EXPECT_EQ(sum.Evaluate({0, 2}), 1002);
}

TEST(TruncateToInt, GoesToTheEndsOfIntWhereTheNumberIsOutside) {
  EXPECT_EQ(TruncateToInt(2.9), 2);
  EXPECT_EQ(TruncateToInt(-2.9), -2);
  EXPECT_EQ(TruncateToInt(1e300), std::numeric_limits<int>::max());
  EXPECT_EQ(TruncateToInt(-1e300), std::numeric_limits<int>::min());
  EXPECT_EQ(TruncateToInt(std::nan("")), 0);
}

}  // namespace
}  // namespace rayshade
