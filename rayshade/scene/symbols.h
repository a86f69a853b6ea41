// Variables, functions and what is computed with them [rayshade4/1 s.5].
#pragma once

#include <deque>
#include <initializer_list>

#include "rayshade/common/expression.h"
#include "rayshade/scene/lexer.h"
#include "rayshade/scene/parser_value.h"
#include "rayshade/scene/reporter.h"

namespace rayshade {

class Symbols {
 public:
  Symbols(Lexer* lexer, Reporter* reporter);

  NumberValue Variable(NameId name);
  NumberValue Call(NameId function, std::initializer_list<NumberValue> arguments);
  NumberValue Operate(ExpressionOp op, std::initializer_list<NumberValue> arguments);
  // The number of an expression that must not vary.
  double Constant(const NumberValue& value);
  // Numbers that overflow, or are none, are errors where something is made of them.
  double Finite(double number);
  void CheckFinite(const NumberValue& value) {
    if (!value.expression) Finite(value.number);
  }
  void Define(NameId name, const NumberValue& value);
  // Values that vary are valid until here.
  void EndItem() {
    if (!made_.empty()) made_.clear();
  }

 private:
  enum class Kind { kUnknown, kValue, kFunction };
  struct Symbol {
    Kind kind = Kind::kUnknown;
    ExpressionOp function = ExpressionOp::kNumber;
    NumberValue constant = {};
    std::vector<Expression> varying;  // at most one
  };

  NumberValue Keep(Expression expression);
  // Reports each unknown name once.
  Symbol& Find(NameId name);

  Lexer* lexer_;
  Reporter* reporter_;
  NameMap<Symbol> symbols_;
  std::deque<Expression> made_;
};

// The value as an expression, constant or not.
Expression ToExpression(const NumberValue& value);

}  // namespace rayshade
