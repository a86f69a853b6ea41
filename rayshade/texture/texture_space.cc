// See texture_space.h.
#include "rayshade/texture/texture_space.h"

#include <algorithm>
#include <limits>

#include "rayshade/common/check.h"

namespace rayshade {

int Truncated(double x) {
  const bool fits = x > -2147483649.0 && x < 2147483648.0;
  return fits ? static_cast<int>(x) : std::numeric_limits<int>::min();
}

double Clamped(double x) {
  if (!(x > 0)) return 0;
  return x > 1 ? 1 : x;
}

const Color& MapEntry(const ColorMap& map, double index) {
  CHECK(map.size() == 256);
  return map[std::clamp(Truncated(index), 0, 255)];
}

TextureSpace::TextureSpace(const TransformChain& transforms) {
  if (transforms.empty()) return;
  identity_ = false;
  if (transforms.animated()) {
    animated_ = transforms;
  } else {
    constant_ = transforms.Whole({});
  }
}

Transform TextureSpace::At(const Moment& moment) const {
  if (animated_.empty()) return constant_;
  Transform whole = animated_.At(0, moment);
  for (size_t i = 1; i < animated_.size(); ++i) whole = Compose(animated_.At(i, moment), whole);
  return whole;
}

Vector TextureSpace::PointOf(const TextureHit& hit) const {
  if (identity_) return hit.point;
  return animated_.empty() ? constant_.InversePoint(hit.point)
                           : At(hit.moment).InversePoint(hit.point);
}

size_t TextureSpace::bytes() const {
  size_t bytes = animated_.size() * sizeof(TransformLink);
  for (const TransformLink& link : animated_.links()) {
    if (const auto* animated = std::get_if<AnimatedTransform>(&link)) {
      for (const Expression& argument : animated->arguments) {
        bytes += sizeof(Expression) + argument.steps().size() * sizeof(ExpressionStep);
      }
    }
  }
  return bytes;
}

}  // namespace rayshade
