// Variables and functions; see symbols.h.
#include "rayshade/scene/symbols.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rayshade {
namespace {

// What an expression is worth after an error: no object becomes degenerate by it.
constexpr NumberValue kAfterError{1, nullptr};
constexpr size_t kMostSteps = 1 << 16;

}  // namespace

Expression ToExpression(const NumberValue& value) {
  return value.expression ? *value.expression : Expression(value.number);
}

Symbols::Symbols(Lexer* lexer, Reporter* reporter) : lexer_(lexer), reporter_(reporter) {
  NameTable* names = lexer->names();
  using Op = ExpressionOp;
  constexpr std::pair<const char*, Op> kFunctions[] = {
      {"cos", Op::kCos},     {"sin", Op::kSin},       {"tan", Op::kTan},
      {"acos", Op::kAcos},   {"asin", Op::kAsin},     {"atan", Op::kAtan},
      {"hypot", Op::kHypot}, {"linear", Op::kLinear}, {"sqrt", Op::kSqrt}};
  for (const auto& [name, op] : kFunctions) {
    Symbol& symbol = symbols_[names->Intern(name)];
    symbol.kind = Kind::kFunction;
    symbol.function = op;
  }
  // Deliberately short, as Rayshade has them.
  constexpr std::pair<const char*, double> kConstants[] = {
      {"pi", 3.141592}, {"dtor", 0.017453}, {"rtod", 57.29578}};
  for (const auto& [name, number] : kConstants) {
    Symbol& symbol = symbols_[names->Intern(name)];
    symbol.kind = Kind::kValue;
    symbol.constant = {number, nullptr};
  }
  for (const auto& [name, op] : {std::pair("time", Op::kTime), std::pair("frame", Op::kFrame)}) {
    Symbol& symbol = symbols_[names->Intern(name)];
    symbol.kind = Kind::kValue;
    symbol.varying.emplace_back(std::vector<ExpressionStep>{{op, 0}});
  }
}

Symbols::Symbol& Symbols::Find(NameId name) {
  Symbol& symbol = symbols_[name];
  if (symbol.kind == Kind::kUnknown) {
    reporter_->Fatal("Symbol " + lexer_->text(name) + " not defined!");
    symbol.kind = Kind::kValue;
    symbol.constant = kAfterError;
  }
  return symbol;
}

NumberValue Symbols::Variable(NameId name) {
  const Symbol& symbol = Find(name);
  if (symbol.kind == Kind::kFunction) {
    reporter_->Fatal("Symbol " + lexer_->text(name) + " is not a float expression!");
    return kAfterError;
  }
  return symbol.varying.empty() ? symbol.constant : Keep(symbol.varying.front());
}

NumberValue Symbols::Call(NameId function, std::initializer_list<NumberValue> arguments) {
  const bool known = symbols_[function].kind != Kind::kUnknown;
  const Symbol& symbol = Find(function);
  if (symbol.kind != Kind::kFunction) {
    if (known) {
      reporter_->Fatal("Symbol " + lexer_->text(function) + " is not a built in function!");
    }
    return kAfterError;
  }
  if (arguments.size() < static_cast<size_t>(RequiredArguments(symbol.function))) {
    reporter_->Error("Too few arguments for " + lexer_->text(function) + ".");
    return kAfterError;
  }
  return Operate(symbol.function, arguments);
}

NumberValue Symbols::Operate(ExpressionOp op, std::initializer_list<NumberValue> arguments) {
  std::vector<Expression> expressions;
  size_t steps = 0;
  for (const NumberValue& argument : arguments) {
    expressions.push_back(ToExpression(argument));
    steps += expressions.back().steps().size();
  }
  if (steps > kMostSteps) {
    reporter_->Error("Expression too long.");
    return kAfterError;
  }
  try {
    return Keep(Apply(op, expressions));
  } catch (const std::runtime_error& error) {
    reporter_->Error(error.what());
    return kAfterError;
  }
}

NumberValue Symbols::Keep(Expression expression) {
  if (!expression.varies()) return {expression.Evaluate({}), nullptr};
  made_.push_back(std::move(expression));
  return {0, &made_.back()};
}

double Symbols::Constant(const NumberValue& value) {
  if (!value.expression) return value.number;
  reporter_->Fatal("Illegal expression use.");
  return kAfterError.number;
}

double Symbols::Finite(double number) {
  if (std::isfinite(number)) return number;
  reporter_->Error("Number is not finite.");
  return kAfterError.number;
}

void Symbols::Define(NameId name, const NumberValue& value) {
  Symbol& symbol = symbols_[name];
  if (symbol.kind != Kind::kUnknown) {
    reporter_->Error("Symbol " + lexer_->text(name) + " redefined.");
    return;
  }
  symbol.kind = Kind::kValue;
  symbol.constant = value;
  symbol.constant.expression = nullptr;
  if (value.expression) symbol.varying.push_back(*value.expression);
}

}  // namespace rayshade
