// What prayshade is told beyond what rayshade knows: how the work is spread.
#pragma once

#include <cstdint>
#include <string>

namespace rayshade::parallel {

enum class Schedule : uint8_t {
  kDataParallel,  // every ray goes to the process that holds the voxel it is in [RJ s.2]
  kDemandDriven,  // whoever asks gets primary rays, and fetches what they meet [RJ s.1]
  kHybrid,        // primary rays on request, secondary rays data parallel [RJ s.3-4]
};
enum class Distribution : uint8_t {
  kGrid,      // equal voxels, one per process [RJ s.2]
  kBalanced,  // so that each process gets its share of the hits that are predicted
};

// A shadow ray that must go on in a cell that is not held.
enum class Shadows : uint8_t {
  kLocal,   // the cell is fetched: shadow rays are traced where they were spawned [RJ s.4, s.7]
  kTravel,  // it goes to the cell's owner, as every other ray does [RJ s.2]
};

struct RunOptions {
  Schedule schedule = Schedule::kHybrid;
  Distribution distribution = Distribution::kGrid;
  Shadows shadows = Shadows::kLocal;
  uint16_t processes = 4;  // trace processes
  uint64_t memory =
      0;  // bytes per trace process for objects, cache and rays in work; 0: not limited
  uint64_t resident = 0;        // bytes of cells that every process holds
  uint64_t cache = 0;           // bytes of fetched cells that a process keeps
  uint32_t pyramid = 1024;      // primary rays in one bundle
  uint32_t rays_in_flight = 0;  // primary rays out at once in the whole run; 0: what memory allows
  uint32_t cell_bytes = 64 << 10;  // a cell is cut while its objects occupy more

  template <class A>
  void Fields(A& a) {
    a("schedule", schedule);
    a("distribution", distribution);
    a("shadows", shadows);
    a("processes", processes);
    a("memory", memory);
    a("resident", resident);
    a("cache", cache);
    a("pyramid", pyramid);
    a("rays_in_flight", rays_in_flight);
    a("cell_bytes", cell_bytes);
  }
};

const char* Name(Schedule schedule);
const char* Name(Shadows shadows);

}  // namespace rayshade::parallel
