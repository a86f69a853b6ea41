#!/bin/bash
# `make figures`: figures 7 and 8 of [RJ s.6] from timelines (parallel/timeline.h): figures.sh BUILD [TIMELINE...]
# Without timelines: balls5 by 16 processes on the simulated machine of the paper, hybrid, and data parallel to compare with.
# Any file that prayshade or prayshade-sim wrote with --timeline may be given instead (TIMELINES=... with make), one or two.
cd "$(dirname "$0")/../.." || exit 2
. doc/charts/experiment.sh
build=$(cd "$1" && pwd) || exit 2
shift
out=$build/figures
mkdir -p "$out" || exit 1

if [ $# = 0 ]; then
  for schedule in hybrid data-parallel; do
    run "$schedule" scenes/balls5.ray -R 256 256 --machine powerxplorer --processes 16 --schedule "$schedule" \
      --timeline "$data/timeline_$schedule.csv" >"$out/result" || exit 1
    [ "$(cat "$out/result")" = "done" ] || { echo "figures: $schedule: out of memory" >&2; exit 1; }
  done
  set -- "$data/timeline_hybrid.csv" "$data/timeline_data-parallel.csv"
fi

# Figure 7: rays of each process, of the first timeline.
awk -F, -v OFS=, 'BEGIN { print "process,data_rays,forwarded_share,demand_rays" }
  $1 == "process" { print $2, $4, $4 ? $5 / $4 : 0, $3 }' "$1" >"$data/figure7.csv" || exit 1
# Figure 8: the share of the processes that is busy, over time since the first ray; a hundred bars at most.
rm -f "$out"/*.bars
number=0
for timeline in "$@"; do
  number=$((number + 1))
  awk -F, -v OFS=, '
    $1 == "run" { schedule = $2; n = $3; begin = $4; end = $5; width = (end - begin) / 100 }
    $1 == "busy" { step = $4 - $3; if (step > widest) widest = step; m++; from[m] = $3; to[m] = $4; busy[m] = $5 }
    END {
      while (width < widest && widest > 0) width += (end - begin) / 100
      bars = int((end - begin) / width + 0.999999)
      for (i = 1; i <= m; i++)  # each interval is spread evenly over the bars that it touches
        for (k = int((from[i] - begin) / width); k <= int((to[i] - begin) / width); k++) {
          a = begin + k * width; b = a + width
          if (a < from[i]) a = from[i]
          if (b > to[i]) b = to[i]
          if (k >= 0 && k < bars && b > a) sum[k] += busy[i] * (b - a) / (to[i] - from[i])
        }
      for (k = 0; k < bars; k++) {
        inside = (begin + (k + 1) * width < end ? width : end - begin - k * width)
        share = sum[k] / (inside * n)
        print schedule, n, k * width, k * width + inside, (share > 1 ? 1 : share)
      }
    }' "$timeline" >"$out/$number.bars" || exit 1
done
{ echo "schedule,processes,from,to,busy_share"; cat "$out"/*.bars; } >"$data/figure8.csv"
echo "$data/figure7.csv $data/figure8.csv"
draw figure7 1000,400
draw figure8 1000,400
