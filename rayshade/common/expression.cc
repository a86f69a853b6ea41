// Expressions on a small stack machine; see expression.h and [rayshade4/1 s.5].
#include "rayshade/common/expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rayshade/common/check.h"
#include "rayshade/common/constants.h"

namespace rayshade {
namespace {

size_t ArgumentCount(ExpressionOp op) {
  switch (op) {
    case ExpressionOp::kNumber:
    case ExpressionOp::kTime:
    case ExpressionOp::kFrame:
      return 0;
    case ExpressionOp::kNegate:
    case ExpressionOp::kCos:
    case ExpressionOp::kSin:
    case ExpressionOp::kTan:
    case ExpressionOp::kAcos:
    case ExpressionOp::kAsin:
    case ExpressionOp::kAtan:
    case ExpressionOp::kSqrt:
      return 1;
    case ExpressionOp::kLinear:
      return 4;
    default:
      return 2;
  }
}

// The C remainder of both numbers truncated to int.
double Remainder(double a, double b) {
  const int64_t dividend = TruncateToInt(a), divisor = TruncateToInt(b);
  if (divisor == 0) throw std::runtime_error("Remainder of a division by zero.");
  return static_cast<double>(dividend % divisor);
}

double Linear(const double* a, double time) {
  const double t0 = a[0], v0 = a[1], t1 = a[2], v1 = a[3];
  if (time < t0) return v0;
  if (time > t1) return v1;
  if (std::abs(t0 - t1) < kEpsilon) return v0;
  return v0 + (v1 - v0) * (time - t0) / (t1 - t0);
}

double Operate(const ExpressionStep& step, const double* a, const Moment& moment) {
  switch (step.op) {
    case ExpressionOp::kNumber:
      return step.number;
    case ExpressionOp::kTime:
      return moment.time;
    case ExpressionOp::kFrame:
      return moment.frame;
    case ExpressionOp::kAdd:
      return a[0] + a[1];
    case ExpressionOp::kSubtract:
      return a[0] - a[1];
    case ExpressionOp::kMultiply:
      return a[0] * a[1];
    case ExpressionOp::kDivide:
      return a[0] / a[1];
    case ExpressionOp::kRemainder:
      return Remainder(a[0], a[1]);
    case ExpressionOp::kNegate:
      return -a[0];
    case ExpressionOp::kPower:
      return std::pow(a[0], a[1]);
    case ExpressionOp::kCos:
      return std::cos(a[0]);
    case ExpressionOp::kSin:
      return std::sin(a[0]);
    case ExpressionOp::kTan:
      return std::tan(a[0]);
    case ExpressionOp::kAcos:
      return std::acos(a[0]);
    case ExpressionOp::kAsin:
      return std::asin(a[0]);
    case ExpressionOp::kAtan:
      return std::atan(a[0]);
    case ExpressionOp::kSqrt:
      return std::sqrt(a[0]);
    case ExpressionOp::kHypot:
      return std::hypot(a[0], a[1]);
    case ExpressionOp::kLinear:
      return Linear(a, moment.time);
  }
  CHECK(!"an operation of the language");
  return 0;
}

// REQUIRES: stack has room for every step.
double Run(const std::vector<ExpressionStep>& steps, const Moment& moment, double* stack) {
  size_t depth = 0;
  for (const ExpressionStep& step : steps) {
    const size_t count = ArgumentCount(step.op);
    CHECK(depth >= count);
    depth -= count;
    stack[depth] = Operate(step, stack + depth, moment);
    ++depth;
  }
  CHECK(depth == 1);
  return stack[0];
}

}  // namespace

int TruncateToInt(double number) {
  if (std::isnan(number)) return 0;
  return static_cast<int>(std::clamp(number, static_cast<double>(std::numeric_limits<int>::min()),
                                     static_cast<double>(std::numeric_limits<int>::max())));
}

bool Expression::varies() const {
  return std::any_of(steps_.begin(), steps_.end(), [](const ExpressionStep& step) {
    return step.op == ExpressionOp::kTime || step.op == ExpressionOp::kFrame ||
           step.op == ExpressionOp::kLinear;
  });
}

double Expression::Evaluate(const Moment& moment) const {
  constexpr size_t kOnStack = 64;
  if (steps_.size() <= kOnStack) {
    std::array<double, kOnStack> stack;
    return Run(steps_, moment, stack.data());
  }
  std::vector<double> stack(steps_.size());
  return Run(steps_, moment, stack.data());
}

Expression Apply(ExpressionOp op, const std::vector<Expression>& arguments) {
  const size_t count = ArgumentCount(op);
  CHECK(arguments.size() >= count);  // surplus ones are ignored [rayshade4/1 s.5.5]
  std::vector<ExpressionStep> steps;
  for (size_t i = 0; i < count; ++i) {
    steps.insert(steps.end(), arguments[i].steps().begin(), arguments[i].steps().end());
  }
  steps.push_back({op, 0});
  Expression whole(std::move(steps));
  return whole.varies() ? whole : Expression(whole.Evaluate({}));
}

int RequiredArguments(ExpressionOp op) { return static_cast<int>(ArgumentCount(op)); }

}  // namespace rayshade
