#!/bin/bash
# `make sensitivity`: each constant of the paper's machine doubled and halved, on balls5 at 256 x 256 by 16 processes.
# Prints the table of doc/cost_model.md and writes doc/charts/data/sensitivity.csv. MACHINE (default powerxplorer).
cd "$(dirname "$0")/../.." || exit 2
. doc/charts/experiment.sh
build=$(cd "$1" && pwd) || exit 2
out=$build/sensitivity machine=parallel/sim/machines/${MACHINE:-powerxplorer}.machine
mkdir -p "$out" || exit 1

if [ "${2:-}" = one ]; then # CONSTANT FACTOR SCHEDULE
  name=$3-$4-$5
  awk -v name="$3" -v factor="$4" '$1 == name { $2 *= factor } { print }' "$machine" >"$out/$name.machine"
  result=$(run "$name" scenes/balls5.ray -R 256 256 --machine "$out/$name.machine" --schedule "$5" --processes 16) || exit 255
  [ "$result" = o.m. ] && seconds=o.m. || seconds=$(value "$out/$name.json" simulated_seconds)
  echo "$3,$4,$5,$seconds" >"$out/$name.row"
  exit 0
fi

rm -f "$out"/*.row
names=$(awk '/^[a-z]/ && $1 != "nodes" && $1 != "processors" && $1 != "host_apart" { print $1 }' "$machine")
{
  for schedule in data-parallel hybrid; do
    echo "as_it_is 1 $schedule"
    for name in $names; do echo "$name 0.5 $schedule"; echo "$name 2 $schedule"; done
  done
} | in_parallel "$0" || { echo "sensitivity: a run failed" >&2; exit 1; }
{ echo "constant,factor,schedule,seconds"; cat "$out"/*.row | sort; } >"$data/sensitivity.csv"
awk -F, -v names="$names" '
  function change(name, factor, schedule,   t) {
    t = seconds[name, factor, schedule]
    return t == "o.m." ? "o.m." : sprintf("%+.1f%%", 100 * (t / seconds["as_it_is", 1, schedule] - 1))
  }
  NR > 1 { seconds[$1, $2, $3] = $4 }
  END {
    printf "balls5, 16 processes: data parallel %.1f s, hybrid %.1f s as it is\n\n", seconds["as_it_is", 1, "data-parallel"], seconds["as_it_is", 1, "hybrid"]
    print "| constant | data parallel, halved | doubled | hybrid, halved | doubled |\n| --- | --- | --- | --- | --- |"
    n = split(names, name, "[ \n]+")
    for (i = 1; i <= n; i++)
      printf "| `%s` | %s | %s | %s | %s |\n", name[i], change(name[i], "0.5", "data-parallel"), change(name[i], "2", "data-parallel"),
        change(name[i], "0.5", "hybrid"), change(name[i], "2", "hybrid")
  }' "$data/sensitivity.csv"
