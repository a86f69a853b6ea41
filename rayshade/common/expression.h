// An arithmetic expression of the scene language, which may vary with time and frame [rayshade4/1
// s.5]: a program for a stack machine. A pure function of the moment.
#pragma once

#include <cstdint>
#include <vector>

namespace rayshade {

struct Moment {
  double frame = 0;
  double time = 0;
};

// The time during which a frame is exposed.
struct ShutterInterval {
  double frame = 0, open = 0, close = 0;
};

enum class ExpressionOp : uint8_t {
  kNumber,
  kTime,
  kFrame,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kRemainder,
  kNegate,
  kPower,
  kCos,
  kSin,
  kTan,
  kAcos,
  kAsin,
  kAtan,
  kSqrt,
  kHypot,
  kLinear,
};

struct ExpressionStep {
  ExpressionOp op = ExpressionOp::kNumber;
  double number = 0;  // of kNumber
  bool operator==(const ExpressionStep&) const = default;
};

class Expression {
 public:
  Expression() : Expression(0.0) {}
  explicit Expression(double number) : steps_{{ExpressionOp::kNumber, number}} {}
  // steps: postfix order; must leave exactly one number (CHECKed by Evaluate).
  explicit Expression(std::vector<ExpressionStep> steps) : steps_(std::move(steps)) {}

  bool varies() const;  // contains kTime, kFrame or kLinear
  // Throws std::runtime_error for a remainder of a division by zero.
  double Evaluate(const Moment& moment) const;
  const std::vector<ExpressionStep>& steps() const { return steps_; }
  bool operator==(const Expression&) const = default;

 private:
  std::vector<ExpressionStep> steps_;
};

// An operation applied to expressions; folded to a number where no argument varies (kLinear always
// varies).
// Surplus arguments are ignored. REQUIRES: at least RequiredArguments(op) of them.
Expression Apply(ExpressionOp op, const std::vector<Expression>& arguments);
int RequiredArguments(ExpressionOp op);

// As C truncates a double to int, but for numbers outside of int, which go to its ends (NaN: 0).
int TruncateToInt(double number);

}  // namespace rayshade
