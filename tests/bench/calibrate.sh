#!/bin/bash
# `make calibrate`: measures this machine for the simulator: calibrate.sh BUILD [operations|contention|messages|machines]
# (all four, in turn, unless one is named):
#   1. operations: sequential runs of eight scenes, and the steps of host and trace processes without PVM (step_costs),
#      unit costs by least squares (fit.awk); with the kernels for this processor, and with the plain ones for machines
#      that have no vector instructions;
#   2. contention: two sequential runs side by side against one;
#   3. messages: ping_pong over PVM, by the project's own transport;
#   4. machines: writes BUILD/this.machine, which `make agreement` uses, brings the lines of parallel/sim/machines/*.machine
#      that are tagged `measured` up to date, and fits powerxplorer's slowness anew.
# CALIBRATE_ROUNDS (default 5): of messages the least time counts. Operations and contention are in processor time: other
# programs that run meanwhile do not count, though they do share caches and memory, and a shared machine is not equally fast all
# the time. So each run of operations has a sequential run of balls4 before it, its own time is taken in proportion to the
# least of those, and the median of all rounds counts.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$(cd "$1" && pwd) || exit 2
phase=${2:-all} rounds=${CALIBRATE_ROUNDS:-5} out=$build/calibrate machines=parallel/sim/machines
mkdir -p "$out" || exit 1
fail() { echo "calibrate: $*" >&2; exit 1; }
wanted() { [ "$phase" = all ] || [ "$phase" = "$1" ]; }
TIMEFORMAT='%R %U %S'
value() { awk -v key="$2" -f tests/support/json_value.awk "$1"; }

# Scenes: four of the usual kind, and four in which one operation outweighs the others.
for n in 4 6; do [ -s "$out/balls$n.ray" ] || "$build/sphereflake" $n --paper >"$out/balls$n.ray" || fail "sphereflake"; done
cp scenes/balls5.ray "$out" || exit 1
for n in 8 30; do cpp -P "scenes/room$n.ray" >"$out/room$n.ray" || fail "cpp"; done
view='eyep 0 -8 3 fov 45 45 sample 1 nojitter contrast 1 1 1 surface s diffuse .5 .5 .5'
echo "$view sphere s .001 0 0 3" >"$out/sky.ray"
echo "$view plane s 0 0 -1 0 -.7 1" >"$out/plane.ray"
{ echo "$view"; for i in {1..30}; do echo "light .03 point $i 1 20"; done; echo "plane s 0 0 -1 0 -.7 1"; } >"$out/lights.ray"

# Of the lines on standard input, for each name (the first field) that with the median time (the second).
medians() {
  sort -k1,1 -k2,2g | awk 'function take() { if (n > 0) print line[int((n + 1) / 2)] }
    $1 != name { take(); name = $1; n = 0 }
    { line[++n] = $0 }
    END { take() }'
}
# The same with the least time.
least() { awk '!($1 in least) || $2 < least[$1] { least[$1] = $2; line[$1] = $0 } END { for (name in line) print line[name] }' | sort; }

sequential_run() { # SCENE PIXELS: a line for fit.awk
  local line seconds name lone_visits lone_tests
  { time "$build/rayshade" -q -R "$2" "$2" --stats "$out/run.json" -O "$out/run.png" "$out/$1.ray"; } 2>"$out/run.time" || fail "$1"
  seconds=$(awk -v seconds="$(value "$out/run.json" trace_seconds)" '{ print seconds * ($2 + $3) / $1 }' "$out/run.time")
  lone_visits=$(value "$out/run.json" operations.lone_visits) lone_tests=$(value "$out/run.json" operations.lone_tests)
  line="$1-$2 $seconds $(value "$out/run.json" rays.total)"
  line="$line $(($(value "$out/run.json" operations.node_visits) - lone_visits))"
  line="$line $(($(value "$out/run.json" operations.primitive_tests) - lone_tests)) $lone_visits $lone_tests"
  for name in cell_steps cell_tests cell_traces shades light_samples; do line="$line $(value "$out/run.json" operations.$name)"; done
  echo "$line 0 0 0 $((2 * $(value "$out/run.json" rays.primary))) 0 0 0"
}
# Lines of a command, behind the seconds of a run of balls4.
beside() {
  local lines beside
  beside=$(sequential_run balls4 512 | awk '{ print $2 }') && [ -n "$beside" ] || fail "balls4"
  lines=$("$@") || fail "$*"
  sed "s/^/$beside /" <<<"$lines"
}
# Rounds, not runs of one scene, follow each other: where the machine is slow for a while, all are.
measure_operations() { # FILE: for fit.awk
  local i scene pixels schedule processes
  "$build/step_costs" >"$1" || fail "step_costs"
  for ((i = 0; i < rounds; i++)); do
    for scene in sky plane lights balls4 balls5 balls6 room8 room30; do
      for pixels in 256 512; do beside sequential_run $scene $pixels; done
    done
    for scene in lights balls4 balls5 balls6 room8; do
      for schedule in data-parallel hybrid; do
        for processes in 1 2; do
          beside "$build/step_costs" "$scene-$schedule-$processes" "$out/$scene.ray" 512 $schedule $processes
        done
      done
    done
  done >"$out/rounds.txt"
  awk 'NR == FNR { if (NR == 1 || $1 < least) least = $1; next }
    $2 ~ /^lights-.*-build$/ { next }  # there nothing is distributed
    { $3 *= least / $1; sub(/^[^ ]+ /, ""); print }' "$out/rounds.txt" "$out/rounds.txt" | medians >>"$1"
}

# Contention: processor time of two sequential runs side by side, against that of one just before; the median.
processor_seconds() { # SCENE N: of N runs at once, each
  local i
  {
    time {
      for ((i = 0; i < $2; i++)); do "$build/rayshade" -q -R 512 512 -O "$out/run$i.png" "$out/$1.ray" & done
      wait
    }
  } 2>&1 | awk -v n="$2" '{ print ($2 + $3) / n }'
}
measure_contention() {
  local i scene
  for ((i = 0; i < rounds; i++)); do
    for scene in balls5 balls6 room8; do
      echo "$scene $(processor_seconds "$scene" 1) $(processor_seconds "$scene" 2)"
    done
  done | awk '{ print $3 / $2 - 1 }' | sort -g | awk -v processors="$(nproc)" '
    { more[NR] = $1 }
    END {
      median = more[int((NR + 1) / 2)]
      printf "two at once take %.3f times as long\n", 1 + median >"/dev/stderr"
      printf "contention %.3g\n", (processors > 1 && median > 0 ? median : 0)
    }' >"$out/contention.txt"
}

measure_messages() {
  local i
  for ((i = 0; i < rounds; i++)); do
    pvm_conf/private-vm "$build/ping_pong" || fail "ping_pong"
  done | least >"$out/messages.txt"
  [ "${PIPESTATUS[0]}" = 0 ] || exit 1
}

if wanted operations; then
  measure_operations "$out/runs.txt" && RAYSHADE_SIMD=plain measure_operations "$out/plain_runs.txt" || exit 1
fi
! wanted contention || measure_contention || exit 1
! wanted messages || measure_messages || exit 1
wanted machines || exit 0
# A byte costs its encoding and its way through PVM.
costs() { # RUNS
  awk -f tests/bench/fit.awk "$1" >"$out/operations.txt" || fail "fit.awk"
  awk '{ cost[$1] = $2 }
    END {
      cost["pack"] += cost["send_byte"]; cost["unpack"] += cost["receive_byte"]
      for (name in cost) if (name !~ /_byte$/) print name, cost[name]
    }' "$out/operations.txt" "$out/contention.txt" "$out/messages.txt" | sort
}
costs "$out/runs.txt" >"$out/costs.txt" && costs "$out/plain_runs.txt" >"$out/plain_costs.txt" || exit 1

# This machine.
awk -v processors="$(nproc)" -v memory="$(awk '/^MemTotal/ { printf "%.0f", 1024 * $2 }' /proc/meminfo)" '
  { cost[$1] = $2 }
  END {
    print "# This machine, by make calibrate."
    print "nodes 1 measured\nprocessors", processors, "measured\nmemory", memory, "measured\nsystem 0 assumed"
    print "host_apart 0 assumed\nslowness 1 measured\nnode_slowness 1 measured"
    for (name in cost) print name, cost[name], "measured"
    print "latency 0 assumed there is one node\ngap 0 assumed\nshared_gap 0 assumed\njitter 0 assumed"
  }' "$out/costs.txt" >"$build/this.machine" || exit 1
cat "$build/this.machine"

# The project's machines: values of lines tagged `measured`; columns stay where they are.
for file in "$machines"/*.machine; do
  [[ $file = */powerxplorer.machine ]] && measured=$out/plain_costs.txt || measured=$out/costs.txt
  awk -v measured="$measured" '
    BEGIN { while ((getline line < measured) > 0) { split(line, part, " "); cost[part[1]] = part[2] } }
    ($1 in cost) && $3 == "measured" { sub(/[^ ]+ */, sprintf("%-16s ", $1)); sub(/ [^ ]+ +[a-z]+/, sprintf(" %-10s %s", cost[$1], $3)) }
    { print }' "$file" >"$out/new.machine" && cp "$out/new.machine" "$file" || fail "$file"
done
file=$machines/powerxplorer.machine
"$build/prayshade-sim" -q --machine "$file" --processes 32 --stats "$out/run.json" -O "$out/run.png" scenes/balls5.ray || fail "prayshade-sim"
slowness=$(awk -v told="$(value "$out/run.json" sequential_seconds)" '
  $1 == "slowness" { slowness = $2 } $1 == "node_slowness" { node = $2 } END { printf "%.4g", slowness * node * 34.5 / told }' "$file")
sed -i -E "s/^(slowness +)[^ ]+ +/\1$(printf '%-11s' "$slowness")/" "$file"
echo "powerxplorer: slowness $slowness, fitted to the sequential time of balls5 in table 1, 34.5 s"
