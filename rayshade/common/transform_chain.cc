// Chains of transformations, folded while they are built; see transform_chain.h.
#include "rayshade/common/transform_chain.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "rayshade/common/check.h"

namespace rayshade {
namespace {

std::optional<Transform> Make(TransformKind kind, const double* a) {
  switch (kind) {
    case TransformKind::kTranslate:
      return Translate({a[0], a[1], a[2]});
    case TransformKind::kScale:
      return Scale({a[0], a[1], a[2]});
    case TransformKind::kRotate: {
      bool degenerate_axis = false;
      return Rotate({a[0], a[1], a[2]}, a[3], &degenerate_axis);
    }
    case TransformKind::kMatrix: {
      Matrix matrix;
      for (int i = 0; i < 9; ++i) matrix.m[i / 3][i % 3] = a[i];
      return FromMatrix(matrix, {a[9], a[10], a[11]});
    }
  }
  return std::nullopt;
}

size_t ArgumentCount(TransformKind kind) {
  return kind == TransformKind::kMatrix ? 12 : kind == TransformKind::kRotate ? 4 : 3;
}

}  // namespace

Transform MakeTransform(TransformKind kind, const double* arguments) {
  if (const std::optional<Transform> made = Make(kind, arguments)) return *made;
  if (kind != TransformKind::kScale) throw DegenerateTransform("Singular matrix.");
  char text[128];
  std::snprintf(text, sizeof text, "Degenerate scale %g %g %g", arguments[0], arguments[1],
                arguments[2]);
  throw DegenerateTransform(text);
}

void TransformChain::Append(const Transform& transform) {
  Transform* last = links_.empty() ? nullptr : std::get_if<Transform>(&links_.back());
  if (last) {
    *last = Compose(*last, transform);
  } else {
    links_.emplace_back(transform);
  }
}

void TransformChain::Append(AnimatedTransform transform) {
  CHECK(transform.arguments.size() == ArgumentCount(transform.kind));
  links_.emplace_back(std::move(transform));
}

bool TransformChain::animated() const {
  return std::any_of(links_.begin(), links_.end(), [](const TransformLink& link) {
    return std::holds_alternative<AnimatedTransform>(link);
  });
}

Transform TransformChain::At(size_t i, const Moment& moment) const {
  CHECK(i < links_.size());
  if (const auto* constant = std::get_if<Transform>(&links_[i])) return *constant;
  const auto& animated = std::get<AnimatedTransform>(links_[i]);
  double arguments[12] = {};
  for (size_t k = 0; k < animated.arguments.size(); ++k) {
    arguments[k] = animated.arguments[k].Evaluate(moment);
  }
  return MakeTransform(animated.kind, arguments);
}

Transform TransformChain::Whole(const Moment& moment) const {
  Transform whole;
  for (size_t i = 0; i < links_.size(); ++i) {
    whole = i == 0 ? At(0, moment) : Compose(whole, At(i, moment));
  }
  return whole;
}

}  // namespace rayshade
