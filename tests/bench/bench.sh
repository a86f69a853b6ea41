#!/bin/bash
# `make bench`: times as ratios, all programs in turn, medians of BENCH_RUNS (default 5) rounds: bench.sh BUILD
# Seconds mean nothing on shared machines; compare the ratios of one run. What is not installed is left out with a word.
# BENCH_PIXELS (1024) is the edge of the pictures; BENCH_SCENES ("balls5 balls6 balls7 room8 room30 conference8
# conference30") what is rendered; RAYSHADE4=/path a user's own binary of the original. doc/performance.md explains the rows.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$(cd "$1" && pwd) || exit 2
if [ "${2:-}" != inside ]; then exec pvm_conf/private-vm "$0" "$build" inside; fi
runs=${BENCH_RUNS:-5} pixels=${BENCH_PIXELS:-1024} out=$build/bench shared=${RAYSHADE_SHARED:-../shared}
scenes=${BENCH_SCENES:-balls5 balls6 balls7 room8 room30 conference8 conference30}
mkdir -p "$out" && rm -f "$out"/*.times || exit 1
fail() { echo "bench: $*" >&2; exit 1; }
wanted() { [[ " $scenes " == *" $1 "* ]]; }
have() { command -v "$1" >/dev/null 2>&1; }

# ---- scenes, each in the forms that are needed ----
have_embree() { [ -x "$build/embree_loop" ]; }
have_embree || echo "Embree is not installed (libembree-dev): left out"
have tachyon || echo "Tachyon is not installed (tachyon): left out"
have povray || echo "POV-Ray is not installed (povray): left out"
[ -n "${RAYSHADE4:-}" ] || echo "The original is not named (RAYSHADE4=/path/to/rayshade): left out"
for scene in $scenes; do
  file=$out/$scene.ray
  case $scene in
    balls*) [ -s "$file" ] || "$build/sphereflake" "${scene#balls}" --paper >"$file" || exit 1
      ! have tachyon || [ -s "$out/$scene.dat" ] || awk -f tests/bench/tachyon_scene.awk "$file" >"$out/$scene.dat"
      ! have povray || [ $scene != balls5 ] || awk -f tests/bench/pov_scene.awk "$file" >"$out/$scene.pov" ;;
    room*) cpp -P "scenes/$scene.ray" >"$file" || exit 1 ;;
    *) gunzip -c "$shared/scenes/$scene.ray.gz" >"$file" 2>/dev/null ||
      { echo "$scene is not there ($shared/scenes): left out"; scenes=${scenes/$scene/}; } ;;
  esac
done

# ---- one run of one program: what it took is appended to NAME.times ----
value() { awk -v key="$2" -f tests/support/json_value.awk "$1"; }
keep() { [ -n "$2" ] || fail "$1 printed no time"; echo "$2" >>"$out/$1.times"; }
ours() { # ours NAME PROGRAM... SCENE: of tracing, and of reading and building
  local name=$1 json=$out/$1.json; shift
  "$@" -q -R "$pixels" "$pixels" --stats "$json" -O "$out/$name.png" >"$out/$name.log" 2>&1 || fail "$(cat "$out/$name.log")"
  keep "$name" "$(value "$json" trace_seconds)"
  keep "$name-read" "$(awk "BEGIN { print $(value "$json" read_seconds) + $(value "$json" build_seconds) }")"
  keep "$name-rays" "$(awk "BEGIN { print $(value "$json" rays.total) / ($(grep -o '"trace_busy_seconds":[0-9.]*' "$json" | cut -d: -f2 | paste -sd+)) }")"
}
embree() { keep "embree-$1" "$("$build/embree_loop" "$out/$1.ray" "$pixels")"; }
tachyon_on() {
  tachyon "$out/$1.dat" +V -numthreads 1 -res "$pixels" "$pixels" -format PNG -o "$out/tachyon.png" | tr '\r' '\n' >"$out/tachyon.log"
  keep "tachyon-$1" "$(awk '/Ray Tracing Time:/ { print $4 }' "$out/tachyon.log")"
  keep "tachyon-$1-read" "$(awk '/Parsing Time:/ { t += $4 } /Preprocessing Time:/ { t += $3 } END { print t }' "$out/tachyon.log")"
}
povray_on() {
  povray +I"$out/$1.pov" +O"$out/povray.png" +W"$pixels" +H"$pixels" -D +WT1 -A >"$out/povray.log" 2>&1
  keep "povray-$1" "$(sed -n 's/.*Trace Time:.*(\([0-9.]*\) seconds).*/\1/p' "$out/povray.log")"
}
whole() { # whole NAME PROGRAM SCENE: processor seconds of the process
  local TIMEFORMAT=%U seconds
  seconds=$({ time "$2" -R "$pixels" "$pixels" -O "$out/$1.out" "$3" >/dev/null 2>&1; } 2>&1) || fail "$2 fails"
  keep "$1" "$seconds"
}

for ((i = 1; i <= runs; i++)); do
  echo "round $i of $runs"
  for scene in $scenes; do
    ours "rayshade-$scene" "$build/rayshade" "$out/$scene.ray"
    ! have_embree || embree "$scene"
    [[ $scene != balls* ]] || ! have tachyon || tachyon_on "$scene"
    [ "$scene" != balls5 ] || ! have povray || povray_on "$scene"
    if [ -n "${RAYSHADE4:-}" ]; then
      whole "whole-$scene" "$build/rayshade" "$out/$scene.ray"
      whole "original-$scene" "$RAYSHADE4" "$out/$scene.ray"
    fi
  done
  wanted balls6 || continue
  ours one-sample-balls6 "$build/rayshade" -S 1 "$out/balls6.ray"
  ours default-balls6 "$build/rayshade" -S 3 -T .2 .15 .3 "$out/balls6.ray"
  for schedule in hybrid data-parallel demand-driven; do
    ours "$schedule-balls6" "$build/prayshade" --processes 2 --schedule $schedule -S 1 "$out/balls6.ray"
    cmp -s "$out/one-sample-balls6.png" "$out/$schedule-balls6.png" || fail "$schedule makes another picture"
  done
  ours lone-balls6 "$build/prayshade" --processes 1 --schedule demand-driven -S 1 "$out/balls6.ray"
  ours hybrid-default-balls6 "$build/prayshade" --processes 2 --schedule hybrid -S 3 -T .2 .15 .3 "$out/balls6.ray"
done

# ---- the table ----
median() { sort -g "$out/$1.times" | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
row() { # row TEXT VALUE BAR [more: at least the bar, instead of at most]
  awk -v text="$1" -v value="$2" -v bar="$3" -v more="${4:-}" 'BEGIN {
    met = bar == "-" ? "" : (more ? value >= bar : value <= bar) ? "met" : "NOT MET"
    printf "%-66s %8.2f   %-10s %s\n", text, value, bar == "-" ? "-" : (more ? ">= " : "<= ") bar, met }'
}
ratio() { # ratio TEXT NAME YARDSTICK BAR [more]
  [ ! -s "$out/$2.times" ] || [ ! -s "$out/$3.times" ] ||
    row "$1" "$(awk "BEGIN { print $(median "$2") / $(median "$3") }")" "$4" "${5:-}"
}
echo
echo "$pixels x $pixels, medians of $runs; one core each but for the processes"
printf '%-66s %8s   %s\n' what ratio bar
balls_bar=0.80 room_bar=0.50
if grep -q avx512 /proc/cpuinfo 2>/dev/null; then balls_bar=0.60 room_bar=0.40; fi
for scene in $scenes; do
  bar=-
  [ $scene != balls5 ] || bar=$balls_bar
  [ "${scene%30}" = "$scene" ] || bar=$room_bar
  ratio "$scene, tracing: rayshade / loop of Embree calls" "rayshade-$scene" "embree-$scene" $bar
  for other in tachyon povray; do ratio "$scene, tracing: rayshade / $other" "rayshade-$scene" "$other-$scene" -; done
  ratio "$scene, whole process: rayshade / the original" "whole-$scene" "original-$scene" -
done
for program in rayshade embree tachyon; do
  bar=-; [ $program != rayshade ] || bar=2.2
  ratio "growth of tracing, balls7 / balls5: $program" $program-balls7 $program-balls5 $bar
done
ratio "balls7, reading and building: rayshade / tachyon" rayshade-balls7-read tachyon-balls7-read 0.6
if wanted balls7; then
  json=$out/rayshade-balls7.json
  row "balls7, peak bytes of the process / spheres" "$(awk "BEGIN { print $(value "$json" peak_bytes) / $(value "$json" objects) }")" 72
fi
if wanted balls6; then
  ratio "balls6, one sample: hybrid on 2 processes / rayshade" hybrid-balls6 one-sample-balls6 0.65
  ratio "balls6, default sampling: hybrid on 2 processes / rayshade" hybrid-default-balls6 default-balls6 0.65
  ratio "balls6, one sample: data-parallel on 2 processes / rayshade" data-parallel-balls6 one-sample-balls6 -
  ratio "balls6, rays per busy second: demand-driven on 1 / rayshade" lone-balls6-rays one-sample-balls6-rays 0.9 more
  ratio "balls6, rays per busy second: demand-driven on 2 / rayshade" demand-driven-balls6-rays one-sample-balls6-rays -
  ratio "balls6, rays per busy second: hybrid on 2 / rayshade" hybrid-balls6-rays one-sample-balls6-rays -
  json=$out/hybrid-balls6.json
  row "balls6, messages per 1000 rays, hybrid on 2" "$(awk "BEGIN { print 1000 * $(value "$json" messages) / $(value "$json" rays.total) }")" 20
fi
