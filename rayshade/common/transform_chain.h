// The transformations written after an object or a texture, in written order: links, each constant
// or a function of the moment. Constant neighbours are folded into one link [rayshade4/1 s.5.8].
// Most objects have none, and an empty chain costs no allocation.
#pragma once

#include <stdexcept>
#include <variant>
#include <vector>

#include "rayshade/common/expression.h"
#include "rayshade/common/transform.h"

namespace rayshade {

enum class TransformKind : uint8_t { kTranslate, kScale, kRotate, kMatrix };

// Arguments: translate 3, scale 3, rotate 4 (axis, degrees), matrix 12 (rows, then translation).
struct AnimatedTransform {
  TransformKind kind = TransformKind::kTranslate;
  std::vector<Expression> arguments;
  bool operator==(const AnimatedTransform&) const = default;
};

// A transformation that cannot be undone; in Rayshade's words.
class DegenerateTransform : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws DegenerateTransform. arguments: 3, 4 or 12.
Transform MakeTransform(TransformKind kind, const double* arguments);

using TransformLink = std::variant<Transform, AnimatedTransform>;

class TransformChain {
 public:
  void Append(const Transform& transform);
  void Append(AnimatedTransform transform);

  // Puts back a link of another chain's links(), without folding.
  void Restore(TransformLink link) { links_.push_back(std::move(link)); }

  bool empty() const { return links_.empty(); }
  bool animated() const;
  size_t size() const { return links_.size(); }
  const std::vector<TransformLink>& links() const { return links_; }

  // Link i at a moment. Throws DegenerateTransform where an animated link is at that moment.
  Transform At(size_t i, const Moment& moment) const;
  // All links composed in written order.
  Transform Whole(const Moment& moment) const;

  bool operator==(const TransformChain&) const = default;

 private:
  std::vector<TransformLink> links_;
};

}  // namespace rayshade
