// A machine that is not there, as the cost model sees it (doc/cost_model.md): what an operation and
// a message cost, and what a node holds. Seconds and bytes. Read from a text:
//
//   machine  = { line }              every number of RAYSHADE_MACHINE once, in any order
//   line     = [ NAME VALUE TAG { word } ] [ "#" comment ]
//   TAG      = "paper" | "manual" | "measured" | "fitted" | "assumed"
//
// TAG says where the value is from; the words behind it say more (fitted: to what). The machines of
// the project's own are such texts: parallel/sim/machines/NAME.machine.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace rayshade::parallel {

// X(name): one number of the description each.
#define RAYSHADE_MACHINE(X)                                                                      \
  X(nodes)                                                                                       \
  X(processors) /* of a node; each has one trace process */                                      \
  X(memory)     /* bytes of a node */                                                            \
  X(system)     /* bytes that operating system, PVM and program take of each processor */        \
  X(host_apart) /* 1: the host has a node of its own; 0: it is on the first */                   \
  X(slowness)   /* operations take so many times as long as stated here, on one processor … */ \
  X(node_slowness) /* … and a node so many times as long as that one */                        \
  X(ray)           /* a ray of any kind begun */                                                 \
  X(node_visit)    /* operations, as in op_counts.h; these two by bundles … */                 \
  X(primitive_test)                                                                              \
  X(lone_visit) /* … and these by rays alone */                                                \
  X(lone_test)                                                                                   \
  X(cell_step)                                                                                   \
  X(cell_test)                                                                                   \
  X(cell_trace)                                                                                  \
  X(shade)                                                                                       \
  X(light_sample)                                                                                \
  X(object)         /* an object stored before tracing, its share of the hierarchy */            \
  X(fetched_object) /* the same while tracing, in the hierarchy of a cell */                     \
  X(lent_object)    /* at the owner of a fetched object: looked up and encoded */                \
  X(sample)         /* a sample handed out or put into the picture */                            \
  X(process_ray)    /* a ray of a trace process in data parallel: spawned or taken up, … */    \
                    /* … and again if handed on; the sequential renderer has none */           \
  X(step)           /* a step of a process, whatever it does */                                  \
  X(send)           /* a message, at its sender */                                               \
  X(receive)        /* a message, at its receiver */                                             \
  X(pack)           /* a byte, at its sender */                                                  \
  X(unpack)         /* a byte, at its receiver */                                                \
  X(latency)        /* from node to node */                                                      \
  X(gap)            /* a byte through the port of a node */                                      \
  X(shared_gap)     /* a byte through what all nodes share; 0: they share nothing */             \
  X(local_latency)  /* within a node */                                                          \
  X(local_gap)                                                                                   \
  X(contention) /* a step takes this share longer for each other busy processor of its node */   \
  X(jitter)     /* a step takes up to this share longer, as the schedule's seed says */

struct Machine {
  std::string name;
#define RAYSHADE_DECLARE(name) double name = 0;
  RAYSHADE_MACHINE(RAYSHADE_DECLARE)
#undef RAYSHADE_DECLARE

  // Bytes that one process may hold.
  double process_bytes() const { return memory / processors - system; }
};

// A machine of the project's own, by name, else a file. Throws
// std::runtime_error naming file, line and what is wrong.
Machine FindMachine(const std::string& name_or_file);

// REQUIRES: every number once, each with its tag. `name` is used in messages.
Machine ParseMachine(const std::string& name, const std::string& text);

// Name and text of each of the project's own; the build makes it from machines/*.machine.
struct BuiltInMachine {
  const char* name;
  const char* text;
};
std::span<const BuiltInMachine> BuiltInMachines();

}  // namespace rayshade::parallel
