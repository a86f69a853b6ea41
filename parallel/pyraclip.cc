// PyraClip; see pyraclip.h.
#include "parallel/pyraclip.h"

#include <algorithm>

namespace rayshade::parallel {

std::vector<ClippedCell> PyraClip(const CellTree& tree, const Pyramid& pyramid, double limit,
                                  const std::function<bool(uint32_t node)>& skip) {
  struct Step {
    uint32_t node;
    Bounds box;
  };
  std::vector<ClippedCell> list;
  std::vector<Step> stack{{0, tree.bounds()}};
  while (!stack.empty()) {
    const Step step = stack.back();
    stack.pop_back();
    if (skip(step.node)) continue;
    const RayInterval interval = Intersect(step.box, pyramid);
    if (interval.empty() || interval.exit < 0 || interval.entry > limit) continue;
    const CellNode& node = tree.nodes()[step.node];
    if (node.axis == 3) {
      list.push_back({node.low, interval.entry});
      continue;
    }
    Step low{node.low, step.box}, high{node.high, step.box};
    low.box.high[node.axis] = node.plane;
    high.box.low[node.axis] = node.plane;
    stack.push_back(high);
    stack.push_back(low);
  }
  std::sort(list.begin(), list.end(), [](const ClippedCell& a, const ClippedCell& b) {
    return a.entry < b.entry || (a.entry == b.entry && a.cell < b.cell);
  });
  return list;
}

}  // namespace rayshade::parallel
