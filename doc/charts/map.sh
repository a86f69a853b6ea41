#!/bin/bash
# `make map`: which schedule wins where: over coherence (longest chain of reflections: none, 1, 5), memory per process (what
# --memory allows: 768 kB, which is little more than 8 processes need, 2 MB and 32 MB) and network speed, for 8, 32 and 128
# processes. The balls of size 5, all of them reflective, 96 x 96. Writes doc/charts/data/map.csv (every run) and map_winners.csv,
# and the chart. About a quarter of an hour on one processor.
cd "$(dirname "$0")/../.." || exit 2
. doc/charts/experiment.sh
build=$(cd "$1" && pwd) || exit 2
out=$build/map
mkdir -p "$out" || exit 1

if [ "${2:-}" = one ]; then # DEPTH MEMORY NETWORK PROCESSES SCHEDULE
  name=$3-$4-$5-$6-$7
  awk -v network="$5" '
    function set(name, value) { if ($1 == name) $2 = value }
    { if (network == "slow") { set("gap", 1e-6); set("latency", 200e-6) }
      if (network == "100g") { set("gap", 0.08e-9); set("latency", 10e-6) }
      print }' parallel/sim/machines/cluster-1g.machine >"$out/$name.machine"
  result=$(run "$name" "$out/balls.ray" -R 96 96 -D "$3" --machine "$out/$name.machine" --memory "$4" --processes "$6" --schedule "$7") || exit 255
  seconds=o.m. share=
  if [ "$result" = "done" ]; then
    seconds=$(value "$out/$name.json" simulated_seconds)
    share=$(awk -v p="$(value "$out/$name.json" rays.primary)" -v s="$(value "$out/$name.json" rays.reflected)" 'BEGIN { printf "%.3f", s / (p + s) }')
  fi
  echo "$3,$share,$4,$5,$6,$7,$seconds" >"$out/$name.row"
  exit 0
fi

sed '/^surface dull/s/$/ reflect .5/' scenes/balls5.ray >"$out/balls.ray" || exit 1
rm -f "$out"/*.row
for processes in 128 32 8; do
  for depth in 0 1 5; do
    for memory in 768K 2M 32M; do
      for network in slow 1g 100g; do
        for schedule in data-parallel demand-driven hybrid; do echo "$depth $memory $network $processes $schedule"; done
      done
    done
  done
done | in_parallel "$0" || { echo "map: a run failed" >&2; exit 1; }
{ echo "depth,secondary_share,memory,network,processes,schedule,seconds"; cat "$out"/*.row | sort; } >"$data/map.csv"
awk -F, -v OFS=, '
  NR == 1 { print "processes,network,memory,depth,winner,times_faster_than_next"; next }
  { k = $5 OFS $4 OFS $3 OFS $1; keys[k]; if ($7 != "o.m.") t[k, $6] = $7 }
  END {
    for (k in keys) {
      best = next_best = ""
      for (i = split("data-parallel demand-driven hybrid", s, " "); i >= 1; i--) {
        if (!((k, s[i]) in t)) continue
        v = t[k, s[i]]
        if (best == "" || v < best) { next_best = best; best = v; winner = s[i] } else if (next_best == "" || v < next_best) next_best = v
      }
      print k, (best == "" ? "o.m." : winner), (best == "" || next_best == "" ? "" : sprintf("%.2f", next_best / best))
    }
  }' "$data/map.csv" | sort -t, -k1,1n -k2,2 -k3,3 -k4,4n >"$data/map_winners.csv"
column -s, -t "$data/map_winners.csv"
draw map 1200,420
