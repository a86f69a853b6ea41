// The machines of the project's own, as texts; doc/cost_model.md explains each number.
#include "parallel/sim/machine.h"

namespace rayshade::parallel {

namespace {

const char kPowerXplorer[] = R"(# Parsytec PowerXplorer, as in the paper [RJ s.5]
nodes            32       paper     "32 Motorola MPC 601 processors"
processors       1        paper
memory           33554432 paper     "a 32 MB local memory"
system           4194304  assumed   PARIX, PVM and the program
host_apart       1        assumed   the host is on the machine in front, or on a node of its own
ray              132e-6   fitted    all operations together: balls5 sequential, 34.5 s on an R8000, taken twice
node_visit       20e-6    fitted    ditto; one to another as measured on a processor of this decade
primitive_test   10.6e-6  fitted    ditto
cell_step        13e-6    fitted    ditto
shade            400e-6   fitted    ditto
light_sample     53e-6    fitted    ditto
object           265e-6   fitted    ditto
sample           66e-6    fitted    ditto
step             50e-6    assumed   a turn of the loop: two probes for messages
send             400e-6   assumed   PVM over PARIX
receive          400e-6   assumed
pack             50e-9    assumed   a copy and a checked write at 20 MB/s
unpack           50e-9    assumed
latency          100e-6   assumed   some hops of transputers that store and forward
gap              0.9e-6   manual    a T800's link: 20 Mbit/s, 1.1 MB/s with its acknowledgements
shared_gap       0.06e-6  assumed   a mesh of 8 x 4: 8 links across its middle, half of all traffic crosses
local_latency    10e-6    assumed
local_gap        20e-9    assumed
jitter           0.05     assumed
)";

// What the two clusters have in common.
const char kClusterNode[] = R"(nodes       32         assumed
processors       1          assumed
memory           8589934592 assumed   8 GB for each processor
system           67108864   assumed
host_apart       1          assumed
ray              100e-9     measured  make calibrate, on a processor of this decade
node_visit       15e-9      measured  ditto
primitive_test   8e-9       measured  ditto
cell_step        10e-9      measured  ditto
shade            300e-9     measured  ditto
light_sample     40e-9      measured  ditto
object           200e-9     measured  ditto
sample           50e-9      measured  ditto
step             0.2e-6     assumed
send             3e-6       measured  PVM's direct route, 200 bytes
receive          3e-6       measured  ditto
pack             0.4e-9     measured  2.5 GB/s
unpack           0.4e-9     measured  ditto
)";

const char kEthernet1G[] = R"(latency     25e-6 assumed   a switch and two TCP stacks
gap              8e-9       manual    1 Gb/s
shared_gap       0          assumed   a switch that does not block
local_latency    1e-6       measured
local_gap        0.4e-9     measured
jitter           0.05       assumed
)";

const char kEthernet100G[] = R"(latency   10e-6 assumed   a switch and two TCP stacks
gap              0.08e-9    manual    100 Gb/s
shared_gap       0          assumed   a switch that does not block
local_latency    1e-6       measured
local_gap        0.4e-9     measured
jitter           0.05       assumed
)";

}  // namespace

std::string BuiltInMachine(const std::string& name) {
  if (name == "powerxplorer") return kPowerXplorer;
  if (name == "cluster-1g") return std::string(kClusterNode) + kEthernet1G;
  if (name == "cluster-100g") return std::string(kClusterNode) + kEthernet100G;
  return "";
}

}  // namespace rayshade::parallel
