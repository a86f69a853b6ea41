// Chains of transformations [rayshade4/1 s.5.8, rayshade4/2 s.3].
#include "rayshade/common/transform_chain.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace rayshade {
namespace {

AnimatedTransform Moving(TransformKind kind, std::vector<Expression> arguments) {
  return {kind, std::move(arguments)};
}
Expression Time() { return Expression({{ExpressionOp::kTime, 0}}); }
Expression Zero() { return Expression(0.0); }
Expression One() { return Expression(1.0); }

std::string WhatIsThrown(const TransformChain& chain, const Moment& moment) {
  try {
    chain.At(0, moment);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(TransformChain, ConstantNeighboursAreFoldedInWrittenOrder) {
  TransformChain chain;
  chain.Append(Translate({1, 0, 0}));
  chain.Append(*Scale({2, 2, 2}));
  EXPECT_EQ(chain.size(), 1u);
  EXPECT_FALSE(chain.animated());
  EXPECT_EQ(chain.Whole({}).Point({0, 0, 0}), (Vector{2, 0, 0}));
  EXPECT_EQ(chain.Whole({}).InversePoint({2, 0, 0}), (Vector{0, 0, 0}));
}

TEST(TransformChain, AnAnimatedLinkIsNotFoldedOnEitherSide) {
  TransformChain chain;
  chain.Append(Translate({1, 0, 0}));
  chain.Append(Moving(TransformKind::kTranslate, {Time(), Zero(), Zero()}));
  chain.Append(*Scale({2, 2, 2}));
  EXPECT_EQ(chain.size(), 3u);
  EXPECT_TRUE(chain.animated());
  EXPECT_EQ(chain.Whole({0, 0}).Point({0, 0, 0}).x, 2);  // [rayshade4/1 s.14.4, last row]
  EXPECT_EQ(chain.Whole({1, 1}).Point({0, 0, 0}).x, 4);
  EXPECT_EQ(chain.Whole({2, 2}).Point({0, 0, 0}).x, 6);
}

TEST(TransformChain, AnimatedMatricesCarryTheirTranslationLast) {
  TransformChain chain;
  std::vector<Expression> numbers(12, Zero());
  numbers[0] = numbers[4] = numbers[8] = One();
  numbers[10] = Time();
  chain.Append(Moving(TransformKind::kMatrix, numbers));
  EXPECT_EQ(chain.At(0, {0, 5}).Point({1, 2, 3}), (Vector{1, 7, 3}));
}

TEST(TransformChain, ALinkThatIsDegenerateAtAMomentThrowsThere) {
  TransformChain scale;
  scale.Append(Moving(TransformKind::kScale, {Time(), One(), One()}));
  EXPECT_EQ(WhatIsThrown(scale, {0, 2}), "");
  EXPECT_EQ(WhatIsThrown(scale, {0, 0}), "Degenerate scale 0 1 1");
  TransformChain rotation;  // about no axis: a scaling by the cosine [rayshade4/2 s.3.2]
  rotation.Append(Moving(TransformKind::kRotate, {Zero(), Zero(), Zero(), Time()}));
  EXPECT_EQ(WhatIsThrown(rotation, {0, 30}), "");
  EXPECT_EQ(WhatIsThrown(rotation, {0, 90}), "Singular matrix.");
}

TEST(TransformChain, AnEmptyOneIsTheIdentity) {
  EXPECT_EQ(TransformChain().Whole({}), Transform());
}

}  // namespace
}  // namespace rayshade
