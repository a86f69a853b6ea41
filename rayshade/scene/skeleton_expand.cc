// From the tree of aggregates to runs of objects with one path each; see skeleton.h.
#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

#include "rayshade/scene/skeleton_tree.h"

namespace rayshade {
namespace {

bool SaysSomething(const Attributes& attributes) {
  return !attributes.plain() || attributes.surface != kNoSurface;
}

class Expander {
 public:
  Expander(const SkeletonTree& tree, const ShutterInterval& shutter)
      : tree_(tree), shutter_(shutter), counts_(tree.nodes.size()), boxes_(tree.nodes.size()) {}

  Expansion Run() {
    expansion_.objects = static_cast<uint32_t>(Count(0));
    Walk(0, 0);
    std::stable_sort(expansion_.runs.begin(), expansion_.runs.end(),
                     [](const ObjectRun& a, const ObjectRun& b) { return a.first < b.first; });
    return std::move(expansion_);
  }

 private:
  // A nested node on the way from the world to the node being walked.
  struct Step {
    const Attributes* attributes;
    NodeId parent;
    bool bounded;
  };

  uint64_t Count(NodeId id) {
    if (counts_[id]) return *counts_[id];
    uint64_t count = 0;
    for (const NodeItem& item : tree_.nodes[id].items) {
      count += item.nested ? Count(item.node) : item.end - item.first;
      if (count > kMaxPlacedObjects) throw std::runtime_error("too many objects in the scene");
    }
    counts_[id] = count;
    return count;
  }

  const Bounds& Box(NodeId id) {
    if (!boxes_[id]) boxes_[id] = MembersBox(tree_, id, shutter_);
    return *boxes_[id];
  }

  // Members in the order in which Rayshade tests them: unbounded ones as written, then the bounded
  // ones, of lists the last written first.
  void Walk(NodeId id, uint64_t order) {
    const TreeNode& node = tree_.nodes[id];
    const auto first_placement = static_cast<PlacementId>(expansion_.placements.size());
    for (const LocalAttributes& local : node.locals) Place(local, id);
    const bool as_written = node.kind == AggregateKind::kGrid;
    for (const NodeItem& item : node.items) {
      if (!item.bounded) order = Visit(id, item, false, first_placement, order);
    }
    for (size_t i = 0; i < node.items.size(); ++i) {
      const NodeItem& item = node.items[as_written ? i : node.items.size() - 1 - i];
      if (item.bounded) order = Visit(id, item, !as_written, first_placement, order);
    }
  }

  uint64_t Visit(NodeId parent, const NodeItem& item, bool backwards, PlacementId first_placement,
                 uint64_t order) {
    if (!item.nested) {
      expansion_.runs.push_back(
          {item.first, item.end, first_placement, static_cast<uint32_t>(order), backwards});
      return order + (item.end - item.first);
    }
    path_.push_back({&tree_.attributes[item.attributes], parent, item.bounded});
    Walk(item.node, order);
    path_.pop_back();
    return order + Count(item.node);
  }

  // Levels that say nothing and clip nothing are left out. A bounded member of a list or grid is
  // tested only for rays that meet the box of all bounded members, and so is what is unbounded
  // inside of it [rayshade4/2 s.8.5].
  void Place(const LocalAttributes& local, NodeId id) {
    Placement placement;
    PathLevel own{local.attributes, {}};
    if (local.endless && !tree_.nodes[id].is_definition) own.clip = Box(id);
    if (own.clip || SaysSomething(own.attributes)) placement.levels.push_back(std::move(own));
    for (size_t i = path_.size(); i-- > 0;) {
      const Step& step = path_[i];
      PathLevel level{*step.attributes, {}};
      const bool may_stick_out = !local.bounded || local.endless;
      if (may_stick_out && step.bounded && !tree_.nodes[step.parent].is_definition) {
        level.clip = Box(step.parent);
      }
      if (level.clip || SaysSomething(level.attributes)) {
        placement.levels.push_back(std::move(level));
      }
    }
    if (placement.levels.empty()) placement.levels.emplace_back();
    placement.Finish();
    expansion_.placements.push_back(std::move(placement));
  }

  const SkeletonTree& tree_;
  const ShutterInterval shutter_;
  std::vector<std::optional<uint64_t>> counts_;
  std::vector<std::optional<Bounds>> boxes_;
  std::vector<Step> path_;  // outermost first
  Expansion expansion_;
};

}  // namespace

Bounds MembersBox(const SkeletonTree& tree, NodeId id, const ShutterInterval& shutter) {
  const TreeNode& node = tree.nodes[id];
  Bounds box = node.box;
  if (!node.moving) return box;
  for (const TreeNode::MovingObject& object : node.moving_objects) {
    box.Include(OuterBounds(node.locals[object.local].attributes, object.box, shutter));
  }
  for (const NodeItem& item : node.items) {
    if (!item.nested || !item.bounded) continue;
    box.Include(OuterBounds(tree.attributes[item.attributes], MembersBox(tree, item.node, shutter),
                            shutter));
  }
  return box;
}

uint64_t PrimitivesIn(const SkeletonTree& tree, NodeId id) {
  std::vector<std::optional<uint64_t>> known(tree.nodes.size());
  const std::function<uint64_t(NodeId)> count = [&](NodeId node_id) {
    std::optional<uint64_t>& sum = known[node_id];
    if (sum) return *sum;
    const TreeNode& node = tree.nodes[node_id];
    uint64_t total = node.primitives_in_csg;
    for (const NodeItem& item : node.items) {
      total += item.nested ? count(item.node) : item.end - item.first;
    }
    sum = total;
    return total;
  };
  return count(id);
}

Expansion ExpandTree(const SkeletonTree& tree, const ShutterInterval& shutter) {
  return Expander(tree, shutter).Run();
}

void RunCursor::Find(uint64_t sequence, const ObjectRun** begin, const ObjectRun** end) {
  const std::vector<ObjectRun>& runs = *runs_;
  if (begin_ == end_ || sequence < runs[begin_].first || sequence >= runs[begin_].end) {
    const auto after =
        std::upper_bound(runs.begin(), runs.end(), sequence,
                         [](uint64_t wanted, const ObjectRun& run) { return wanted < run.first; });
    end_ = static_cast<size_t>(after - runs.begin());
    begin_ = end_;
    if (end_ > 0 && sequence < runs[end_ - 1].end) {
      while (begin_ > 0 && runs[begin_ - 1].first == runs[end_ - 1].first) --begin_;
    }
  }
  *begin = runs.data() + begin_;
  *end = runs.data() + end_;
}

}  // namespace rayshade
