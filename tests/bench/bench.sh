#!/bin/bash
# `make bench`: tracing times as ratios, all programs in turn, medians of BENCH_RUNS (default 5) rounds: bench.sh BUILD
# Seconds mean nothing on shared machines; compare the ratios of one run. What is not installed is left out with a word.
# BENCH_PIXELS (default 1024) is the edge of the pictures.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$(cd "$1" && pwd) || exit 2
if [ "${2:-}" != inside ]; then exec pvm_conf/private-vm "$0" "$build" inside; fi
runs=${BENCH_RUNS:-5} pixels=${BENCH_PIXELS:-1024} out=$build/bench
mkdir -p "$out" || exit 1
[ -s "$out/balls6.ray" ] || "$build/sphereflake" 6 --paper >"$out/balls6.ray" || exit 1
cp scenes/balls5.ray "$out/balls5.ray"
cpp -P scenes/room30.ray >"$out/room30.ray" 2>/dev/null || exit 1

value() { awk -v key="$2" -f tests/support/json_value.awk "$1"; }
timed() { # timed NAME COMMAND...: appends the tracing seconds to NAME.times
  local name=$1; shift
  "$@" -q -R "$pixels" "$pixels" --stats "$out/$name.json" -O "$out/$name.png" >"$out/$name.log" 2>&1 ||
    { cat "$out/$name.log" >&2; echo "bench: $name failed" >&2; exit 1; }
  value "$out/$name.json" trace_seconds >>"$out/$name.times"
}
median() { sort -g "$out/$1.times" | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
ratio() { # ratio TEXT NAME YARDSTICK BAR
  awk -v text="$1" -v a="$(median "$2")" -v b="$(median "$3")" -v bar="$4" \
    'BEGIN { printf "%-58s %6.2f  (%.3f s / %.3f s)  bar %s\n", text, a / b, a, b, bar }'
}

rm -f "$out"/*.times
for ((i = 1; i <= runs; i++)); do
  echo "round $i of $runs"
  for scene in balls5 room30; do
    timed "rayshade-$scene" "$build/rayshade" "$out/$scene.ray"
    [ ! -x "$build/embree_loop" ] || "$build/embree_loop" "$out/$scene.ray" "$pixels" >>"$out/embree-$scene.times"
  done
  timed rayshade-balls6 "$build/rayshade" "$out/balls6.ray"
  for schedule in data-parallel hybrid; do
    timed "$schedule-balls6" "$build/prayshade" --processes 2 --schedule "$schedule" "$out/balls6.ray"
    cmp -s "$out/rayshade-balls6.png" "$out/$schedule-balls6.png" || { echo "bench: $schedule makes another picture" >&2; exit 1; }
  done
done
echo
echo "tracing at $pixels x $pixels, medians of $runs"
if [ -x "$build/embree_loop" ]; then
  ratio "rayshade / loop of Embree calls, balls5" rayshade-balls5 embree-balls5 3.1
  ratio "rayshade / loop of Embree calls, room30" rayshade-room30 embree-room30 -
else
  echo "Embree is not installed (libembree-dev): its loop is left out"
fi
ratio "hybrid on 2 / rayshade, balls6" hybrid-balls6 rayshade-balls6 0.65
ratio "data-parallel on 2 / rayshade, balls6" data-parallel-balls6 rayshade-balls6 -
awk -v m="$(value "$out/hybrid-balls6.json" messages)" -v r="$(value "$out/hybrid-balls6.json" rays.total)" \
  'BEGIN { printf "%-58s %6.4f  bar 0.02\n", "messages per ray, hybrid on 2, balls6", m / r }'
