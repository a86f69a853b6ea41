// The tree that a Skeleton keeps: one node for the world, for each list and grid outside of CSG,
// and for each definition. Private to skeleton*.cc.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "rayshade/common/bounds.h"
#include "rayshade/geom/spec.h"
#include "rayshade/scene/placement.h"
#include "rayshade/scene/skeleton.h"

namespace rayshade {

using NodeId = uint32_t;

// What is written around objects of one node.
struct LocalAttributes {
  Attributes attributes;
  bool bounded = true;   // of the objects: unbounded ones are clipped by enclosing aggregates
  bool endless = false;  // bounded by Rayshade's reckoning, though hits may lie anywhere
};

// Members of a node, in written order: neighbouring objects, or one nested node.
struct NodeItem {
  bool nested = false;
  bool bounded = true;
  uint64_t first = 0, end = 0;  // of objects
  NodeId node = 0;              // nested: an aggregate, or a definition that is placed here
  uint32_t attributes = 0;      // nested: what is written around it, in SkeletonTree::attributes
};

struct TreeNode {
  AggregateKind kind = AggregateKind::kList;
  int counts[3] = {1, 1, 1};
  bool is_definition = false;  // its one item stands for itself; it is no level of a path
  bool bounded = false;        // has a bounded member
  bool moving = false;         // `box` leaves something out, since it moves
  Bounds box;                  // of the bounded members that stand still, in the node's space
  std::vector<NodeItem> items;
  uint64_t primitives_in_csg = 0;       // of its own
  std::vector<LocalAttributes> locals;  // by local placement
  struct MovingObject {
    Bounds box;  // in its own space
    LocalPlacement local;
  };
  std::vector<MovingObject> moving_objects;
};

struct SkeletonTree {
  std::deque<TreeNode> nodes;         // the world is the first
  std::deque<Attributes> attributes;  // of nested nodes; the first is for those without any
};

// The box of a node's bounded members, in the node's space.
Bounds MembersBox(const SkeletonTree& tree, NodeId node, const ShutterInterval& shutter);

// Primitives that a node places, those inside of CSG one by one; as Rayshade counts them.
uint64_t PrimitivesIn(const SkeletonTree& tree, NodeId node);

// Runs and placements of all objects that the world reaches.
Expansion ExpandTree(const SkeletonTree& tree, const ShutterInterval& shutter);

}  // namespace rayshade
