// Which process owns which cells. `grid`: "split the object space into (equal sized) voxels
// exploiting local object coherence. Each processor is assigned a process and a voxel with its
// objects" [RJ s.2]. Voxels are cut further into cells, the unit in which objects are made resident
// and fetched.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/object_spool.h"
#include "parallel/run_options.h"

namespace rayshade::parallel {

// How n equal voxels are cut along the three axes: the most even factors, the largest along the
// longest side. 24 is 4 x 3 x 2.
std::array<int, 3> GridCounts(int n, const Vector& extent);

// The subdivision of the scene in the spool: first the voxel planes, then cuts in the middle of the
// longest side while a cell's objects occupy more than options.cell_bytes and cutting helps. Reads
// the spool once for every three levels.
CellTree BuildTree(const RunOptions& options, ObjectSpool* spool);

// Marks the cells nearest to the eye as resident while their bytes stay within the budget [RJ s.4,
// figure 4].
void ChooseResidentSet(const Vector& eye, uint64_t budget, CellTree* tree);

// Bytes of objects that each process will hold for good; [0] is process 1.
std::vector<uint64_t> BytesHeld(const RunOptions& options, const CellTree& tree,
                                ObjectSpool* spool);

// The least number of processes (of a few that are tried, up to 4096) whose fullest voxel fits
// beside `spare` bytes; 0 where none does.
int ProcessesThatWouldDo(uint64_t memory, uint64_t spare, ObjectSpool* spool);

}  // namespace rayshade::parallel
