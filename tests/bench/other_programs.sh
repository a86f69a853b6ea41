#!/bin/bash
# Tachyon's and POV-Ray's antialiasing of the balls beside ours (`make accuracy`): other_programs.sh BUILD DATA
# Writes DATA/others-balls.csv: our curves out of antialiasing-balls.csv, and theirs. Times are what the programs say of tracing,
# on one thread, medians of three, in yardsticks of our one plain sample per pixel at the same size. Errors are taken against
# the mean of our 32 x 32 samples in each pixel: the three programs render the balls alike, to a few hundredths of 1/255.
# A program that is not installed is left out with a word.
set -u
build=$(cd "$1" && pwd) data=$2 pixels=96
out=$build/other_programs csv=$data/others-balls.csv
mkdir -p "$out" || exit 1
large=$((32 * pixels))

median() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
thrice() { for _ in 1 2 3; do "$@" || exit 1; done | median; }
point() { # point CURVE PARAMETER SECONDS PICTURE REFERENCE
  local error
  error=$("$build/compare_blocks" "$4" "$5") || exit 1
  awk -v curve="$1" -v parameter="$2" -v seconds="$3" -v yardstick="$yardstick" -v error="$error" 'BEGIN {
    split(error, e, " "); printf "%s,%s,%.3f,%s,%s,,,,0\n", curve, parameter, seconds / yardstick, e[1], e[2] }' >>"$csv"
  tail -n 1 "$csv" >&2
}

ours() {
  "$build/rayshade" -q -S 1 -j -R "$pixels" "$pixels" --stats "$out/stats.json" -O "$out/ours.png" scenes/balls5.ray &&
    awk -v key=trace_seconds -f tests/support/json_value.awk "$out/stats.json"
}
tachyon_run() { # tachyon_run OPTIONS: seconds of tracing; the picture is $out/tachyon.png
  tachyon "$out/balls.dat" -numthreads 1 -shade_phong -format PNG -o "$out/tachyon.png" "$@" 2>&1 | tr '\r' '\n' |
    awk '/Ray Tracing Time/ { print $4; done = 1 } END { exit !done }'
}
povray_run() {
  povray "+I$out/balls.pov" "+O$out/povray.png" +FN8 -D +WT1 File_Gamma=1.0 "+W$pixels" "+H$pixels" "$@" 2>&1 |
    sed -nE 's/.*Trace Time:.*\(([0-9.]+) seconds\).*/\1/p'
}

grep -E '^curve|^regular|^jittered|^low-discrepancy' "$data/antialiasing-balls.csv" | sed 's/,[01]$/,0/' >"$csv" || exit 1
yardstick=$(thrice ours) || exit 1
"$build/rayshade" -q -R "$large" "$large" --quality reference -S 1 -O "$out/ours-large.png" scenes/balls5.ray || exit 1

if command -v tachyon >/dev/null 2>&1; then
  awk -v to=tachyon -f tests/bench/balls_for_others.awk scenes/balls5.ray >"$out/balls.dat"
  for samples in 0 1 3 7 15 31 63; do
    seconds=$(thrice tachyon_run -res "$pixels" "$pixels" -aasamples "$samples") || exit 1
    point "Tachyon: random samples" "$((samples + 1))" "$seconds" "$out/tachyon.png" "$out/ours-large.png"
  done
else
  echo "Tachyon is not installed: its curve is left out"
fi

if command -v povray >/dev/null 2>&1; then
  awk -v to=povray -f tests/bench/balls_for_others.awk scenes/balls5.ray >"$out/balls.pov"
  for side in 1 2 3 4 6; do
    seconds=$(thrice povray_run +A0.0 +AM1 "+R$side" +J1.0) || exit 1
    point "POV-Ray: jittered n x n (+AM1 +A0)" "$side x $side" "$seconds" "$out/povray.png" "$out/ours-large.png"
  done
  for threshold in 0.5 0.3 0.1 0.03; do
    seconds=$(thrice povray_run "+A$threshold" +AM2 +R3 +J1.0) || exit 1
    point "POV-Ray: adaptive (+AM2 +R3)" "+A$threshold" "$seconds" "$out/povray.png" "$out/ours-large.png"
  done
else
  echo "POV-Ray is not installed: its curves are left out"
fi
