// The distribution `balanced`: cells are shared out so that each process gets its part of the work
// that is predicted, where `grid` gives it an equal part of space. The paper measures equal voxels
// and finds imbalances "near the viewpoint and the light sources" [RJ s.2].
#pragma once

#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/object_spool.h"
#include "rayshade/render/camera.h"

namespace rayshade::parallel {

// Where the primary rays of a picture are expected to hit.
struct PredictedHits {
  std::vector<double> by_cell;  // share of the picture's hits, all together at most 1
  int across = 0;               // squares across the picture, and down
  std::vector<CellId> cells;    // by square, row by row; kNoCell: nothing is hit
};

// Rays to a grid of pixels against the ellipsoids in the objects' boxes: geometry need not be
// decoded for a guess. Reads the spool once.
PredictedHits PredictHits(const Camera& camera, const CellTree& tree, ObjectSpool* spool);

// What the prediction weighs each cell with: its hits, and a part for its bytes, since secondary
// rays meet what the eye does not see.
std::vector<double> WorkByCell(const std::vector<double>& hits, const CellTree& tree);
// The bytes of each cell, for scenes that leave no choice.
std::vector<double> BytesByCell(const CellTree& tree);

// Sets the owners: the cells in the order of the tree, which keeps neighbours together, cut into
// runs of equal weight, one for each process.
void ShareOut(const std::vector<double>& weights, int processes, CellTree* tree);

}  // namespace rayshade::parallel
