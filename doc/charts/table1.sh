#!/bin/bash
# `make table1`: table 1 of [RJ s.6] on the simulated machine of the paper, beside the paper's own figures.
# Pictures are 256 x 256, as the paper's. Data parallel is run with shadow rays traced where they were spawned ("local") and
# with shadow rays that travel. Writes doc/charts/data/table1.csv and the chart. MACHINE (default powerxplorer).
cd "$(dirname "$0")/../.." || exit 2
. doc/charts/experiment.sh
build=$(cd "$1" && pwd) || exit 2
out=$build/table1 machine=${MACHINE:-powerxplorer}
mkdir -p "$out" || exit 1

if [ "${2:-}" = one ]; then # SCENE ROOM SCHEDULE SHADOWS PROCESSES
  name=$3-$5-$6-$7
  result=$(run "$name" "$out/$3.ray" -R 256 256 --machine "$machine" --schedule "$5" --shadows "$6" --processes "$7") || exit 255
  room=-; [ "$3" = balls5 ] || room=$4
  row="$3,$room,$5,$6,$7"
  if [ "$result" = o.m. ]; then
    row="$row,o.m.,,,,"
  else
    for key in simulated_seconds sequential_seconds efficiency_sequential smallest_processes efficiency_smallest; do
      row="$row,$(value "$out/$name.json" $key)"
    done
  fi
  echo "$row" >"$out/$name.row"
  exit 0
fi

make_scenes
rm -f "$out"/*.row
for scene in room30 room8 balls5; do
  for processes in 1 2 4 8 16 24 32; do
    echo "$scene $room data-parallel travel $processes"
    echo "$scene $room data-parallel local $processes"
    echo "$scene $room hybrid local $processes"
  done
done | in_parallel "$0" || { echo "table1: a run failed" >&2; exit 1; }

csv=$data/table1.csv
{
  echo "scene,room,schedule,shadows,processes,seconds,sequential_seconds,efficiency_sequential,smallest_processes,efficiency_smallest"
  for scene in balls5 room8 room30; do
    for way in data-parallel-local data-parallel-travel hybrid-local; do
      for processes in 1 2 4 8 16 24 32; do cat "$out/$scene-$way-$processes.row"; done
    done
  done
} >"$csv"

echo "Seconds by machine $machine; the room is $(room_name "$room")."
echo "efficiency: against the sequential renderer on the same machine / against the smallest number of processes that fits"
awk -F, '
  function cell(s, k) { return (s, k) in t ? t[s, k] : "" }
  function show(key) { return t[key] == "o.m." ? sprintf("%22s", "o.m.") : sprintf("%8.1f  %5.3f /%5.3f", t[key], e[key], f[key]) }
  FNR == 1 { file++; next }
  file == 1 { p[$1, $2, $3] = $4; next }
  { key = $1 SUBSEP $3 "-" $4 SUBSEP $5; t[key] = $6; e[key] = $8; f[key] = $10; if ($7 != "") sequential[$1] = $7 }
  END {
    split("34.5 100.0 264.2", optimum, " "); split("balls5 room8 room30", scenes, " "); split("1 2 4 8 16 24 32", n, " ")
    for (i = 1; i <= 3; i++) {
      s = scenes[i]
      printf "\n%s: sequential %.1f s on the node (paper: %.1f s on an R8000)\n", s, sequential[s], optimum[i]
      printf "%5s |%8s %22s %22s |%8s %22s\n", "procs", "paper DP", "ours, shadows local", "ours, shadows travel", "paper hyb", "ours"
      for (j = 1; j <= 7; j++)
        printf "%5d |%8s %s %s |%8s %s\n", n[j], p[s, "data-parallel", n[j]], show(s SUBSEP "data-parallel-local" SUBSEP n[j]),
          show(s SUBSEP "data-parallel-travel" SUBSEP n[j]), p[s, "hybrid", n[j]], show(s SUBSEP "hybrid-local" SUBSEP n[j])
    }
  }' "$data/paper_table1.csv" "$csv"
echo
echo "$csv"
draw table1 1400,480
