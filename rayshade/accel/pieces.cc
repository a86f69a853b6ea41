// Dividing by counting; see pieces.h.
#include "rayshade/accel/pieces.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "rayshade/accel/split.h"

namespace rayshade {
namespace {

constexpr int kLeastCells = 8;     // blocks that are smaller are not divided by this grid
constexpr int kDepthOfGrids = 24;  // below, halves are taken: 17 levels for 2^32 objects

struct Cell {
  Box box = Box::Empty();
  uint32_t spheres = 0, refs = 0;
  uint32_t leaf = 0;  // what it became a part of
};

// A part of the grid, half open.
struct Block {
  int low[3], high[3];
};

// A block, seen along each axis; and what it holds.
struct Slabs {
  Bin bins[3][kBinsMax];
  Box box = Box::Empty();
  uint32_t spheres = 0, refs = 0;

  uint32_t count() const { return spheres + refs; }
};

class PieceMaker {
 public:
  explicit PieceMaker(BuildObjects* objects) : objects_(*objects) {}

  std::vector<Piece> Run() {
    Piece all;
    all.sphere_end = objects_.sphere_count();
    all.ref_end = objects_.ref_count();
    AddWithBox(all);
    work_.push_back({0, 0});
    while (!work_.empty()) {
      const auto [piece, depth] = work_.back();
      work_.pop_back();
      if (pieces_[piece].count() <= kPieceMax) continue;
      if (depth >= kDepthOfGrids || !DivideByGrid(piece, depth)) Halve(piece, depth);
    }
    return std::move(pieces_);
  }

 private:
  struct Work {
    uint32_t piece;
    int depth;
  };

  template <typename Visit>
  void ForEachBox(const Piece& piece, const Visit& visit) const {
    for (uint32_t i = piece.sphere_begin; i < piece.sphere_end; ++i) visit(objects_.BoxOfSphere(i));
    for (uint32_t i = piece.ref_begin; i < piece.ref_end; ++i) visit(objects_.BoxOfRef(i));
  }

  uint32_t AddWithBox(Piece piece) {
    ForEachBox(piece, [&](const Box& box) { piece.box.Include(box); });
    pieces_.push_back(piece);
    return static_cast<uint32_t>(pieces_.size() - 1);
  }

  // Where a grid finds nothing.
  void Halve(uint32_t whole, int depth) {
    Piece left = pieces_[whole], right = left;
    left.box = right.box = Box::Empty();
    left.sphere_end = right.sphere_begin = left.sphere_begin + left.spheres() / 2;
    left.ref_end = right.ref_begin = left.ref_begin + left.refs() / 2;
    for (const Piece& part : {left, right}) {
      const uint32_t added = AddWithBox(part);
      pieces_[whole].parts[&part == &right] = added;
      work_.push_back({added, depth + 1});
    }
  }

  // False where all objects are in one place.
  bool DivideByGrid(uint32_t piece, int depth) {
    const Intervals grid = CountInCells(pieces_[piece]);
    leaves_.clear();
    next_sphere_ = pieces_[piece].sphere_begin;
    next_ref_ = pieces_[piece].ref_begin;
    DivideBlock({{0, 0, 0}, {cells_along_[0], cells_along_[1], cells_along_[2]}}, piece, depth);
    if (leaves_.size() == 1) return false;
    work_.insert(work_.end(), leaves_.begin(), leaves_.end());
    const auto leaf_of = [&](const Box& box) { return CellOf(grid, box).leaf; };
    Move(
        &Piece::sphere_begin, &Piece::sphere_end,
        [&](uint32_t i) { return leaf_of(objects_.BoxOfSphere(i)); },
        [&](uint32_t i, uint32_t j) {
          objects_.PrefetchSphere(j + 4);  // leaves are more streams than a processor foresees
          objects_.SwapSpheres(i, j);
        });
    Move(
        &Piece::ref_begin, &Piece::ref_end,
        [&](uint32_t i) { return leaf_of(objects_.BoxOfRef(i)); },
        [&](uint32_t i, uint32_t j) { objects_.SwapRefs(i, j); });
    return true;
  }

  // About as many cells as objects, at most kBinsMax along the longest side.
  Intervals CountInCells(const Piece& piece) {
    Box centers = Box::Empty();
    ForEachBox(piece, [&](const Box& box) { centers.Include(box.doubled_center()); });
    const F4 extent = centers.high - centers.low;
    const float longest = std::max({extent[0], extent[1], extent[2]});
    const float most = std::min(std::cbrt(static_cast<float>(piece.count())), float{kBinsMax});
    for (int axis = 0; axis < 3; ++axis) {
      const float part = longest > 0 ? extent[axis] / longest : 0;
      cells_along_[axis] = std::max(1, static_cast<int>(most * part));
    }
    const Intervals grid(centers, cells_along_);
    cells_.assign(size_t{1} * cells_along_[0] * cells_along_[1] * cells_along_[2], Cell());
    for (uint32_t i = piece.sphere_begin; i < piece.sphere_end; ++i) {
      const Box box = objects_.BoxOfSphere(i);
      Cell& cell = CellOf(grid, box);
      cell.box.Include(box);
      ++cell.spheres;
    }
    for (uint32_t i = piece.ref_begin; i < piece.ref_end; ++i) {
      const Box box = objects_.BoxOfRef(i);
      Cell& cell = CellOf(grid, box);
      cell.box.Include(box);
      ++cell.refs;
    }
    return grid;
  }

  Cell& CellAt(int x, int y, int z) {
    return cells_[(size_t{1} * z * cells_along_[1] + y) * cells_along_[0] + x];
  }
  Cell& CellOf(const Intervals& grid, const Box& box) {
    const I4 at = grid.Of(box);
    return CellAt(at[0], at[1], at[2]);
  }
  template <typename Visit>
  void ForEachCell(const Block& b, const Visit& visit) {
    for (int z = b.low[2]; z < b.high[2]; ++z) {
      for (int y = b.low[1]; y < b.high[1]; ++y) {
        for (int x = b.low[0]; x < b.high[0]; ++x) visit(&CellAt(x, y, z), x, y, z);
      }
    }
  }

  void Look(const Block& block, Slabs* slabs) {
    for (auto& bins : slabs->bins) std::fill(bins, bins + kBinsMax, Bin{Box::Empty(), 0});
    ForEachCell(block, [&](const Cell* cell, int x, int y, int z) {
      const uint32_t count = cell->spheres + cell->refs;
      if (count == 0) return;
      for (Bin* bin : {&slabs->bins[0][x], &slabs->bins[1][y], &slabs->bins[2][z]}) {
        bin->box.Include(cell->box);
        bin->count += count;
      }
      slabs->box.Include(cell->box);
      slabs->spheres += cell->spheres;
      slabs->refs += cell->refs;
    });
  }

  // The best border, after the block has been cut to what holds objects; none where it is small.
  static Border FindBorderIn(const Slabs& slabs, Block* block) {
    Border best;
    bool large = false;
    for (int axis = 0; axis < 3; ++axis) {
      int& low = block->low[axis];
      int& high = block->high[axis];
      while (slabs.bins[axis][low].count == 0) ++low;
      while (slabs.bins[axis][high - 1].count == 0) --high;
      large |= high - low >= kLeastCells;
    }
    if (!large || slabs.count() <= kPieceMax) return best;
    for (int axis = 0; axis < 3; ++axis) {
      const int low = block->low[axis];
      Border border;
      FindBorder(slabs.bins[axis] + low, block->high[axis] - low, axis, slabs.count(), &border);
      if (border.cost < best.cost) best = {border.cost, axis, border.last_left + low};
    }
    return best;
  }

  // A block that is divided no more is a leaf, with its objects next to those of the leaf before.
  void DivideBlock(Block block, uint32_t piece, int depth) {
    const uint32_t first_sphere = next_sphere_, first_ref = next_ref_;
    Border border;
    {
      const auto slabs = std::make_unique<Slabs>();
      Look(block, slabs.get());
      pieces_[piece].box = slabs->box;
      if (depth < kDepthOfGrids) border = FindBorderIn(*slabs, &block);
      if (border.axis < 0) MakeLeaf(block, *slabs, piece, depth);
    }
    if (border.axis >= 0) {
      for (const int side : {0, 1}) {
        Block part = block;
        (side == 0 ? part.high : part.low)[border.axis] = border.last_left + 1;
        const uint32_t added = static_cast<uint32_t>(pieces_.size());
        pieces_.emplace_back();
        pieces_[piece].parts[side] = added;
        DivideBlock(part, added, depth + 1);
      }
    }
    Piece& done = pieces_[piece];
    done.sphere_begin = first_sphere;
    done.sphere_end = next_sphere_;
    done.ref_begin = first_ref;
    done.ref_end = next_ref_;
  }

  void MakeLeaf(const Block& block, const Slabs& slabs, uint32_t piece, int depth) {
    const uint32_t leaf = static_cast<uint32_t>(leaves_.size());
    ForEachCell(block, [&](Cell* cell, int, int, int) { cell->leaf = leaf; });
    leaves_.push_back({piece, depth});
    next_sphere_ += slabs.spheres;
    next_ref_ += slabs.refs;
  }

  // Brings objects to their leaves: each of them into the next free place of its own.
  template <typename LeafOf, typename Swap>
  void Move(uint32_t Piece::*begin, uint32_t Piece::*end, const LeafOf& leaf_of, const Swap& swap) {
    std::vector<uint32_t> next;
    for (const Work& leaf : leaves_) next.push_back(pieces_[leaf.piece].*begin);
    for (uint32_t leaf = 0; leaf < leaves_.size(); ++leaf) {
      while (next[leaf] < pieces_[leaves_[leaf].piece].*end) {
        const uint32_t at = leaf_of(next[leaf]);
        if (at == leaf) {
          ++next[leaf];
        } else {
          swap(next[leaf], next[at]++);
        }
      }
    }
  }

  BuildObjects& objects_;
  std::vector<Piece> pieces_;
  std::vector<Work> work_;
  // Of the grid at work.
  std::vector<Cell> cells_;
  int cells_along_[3];
  std::vector<Work> leaves_;
  uint32_t next_sphere_, next_ref_;
};

}  // namespace

std::vector<Piece> DivideIntoPieces(BuildObjects* objects) { return PieceMaker(objects).Run(); }

}  // namespace rayshade
