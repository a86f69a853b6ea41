#!/bin/bash
# `make agreement`: the simulator against real runs over PVM on this machine, by BUILD/this.machine of `make calibrate`:
#   agreement.sh BUILD [measure|simulate|compare]
# (all three, in turn, unless one is named). Prints each comparison with its bar; the status is 0 where all are met.
# AGREEMENT_ROUNDS (default 9): real times are the medians of so many runs, real counts their means, with the least and the largest
# behind them where they differ. Means, because the host shares a processor with the one or with the other of two trace processes:
# the counts of hybrid runs are of two kinds, and a median is of one of them. AGREEMENT_PIXELS (default 512).
# A shared machine is not equally fast all the time, and slower where more of it is at work: each run has sequential runs of
# balls4 before and behind it, at once on as many processors as the run has trace processes for, and its own time is taken in
# proportion to what the machine's constants tell of them. Where other programs take over a fifth of a processor during these,
# the run is made again, AGREEMENT_TRIES times (default 3) at most; what remains disturbed is counted.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$(cd "$1" && pwd) || exit 2
phase=${2:-all} rounds=${AGREEMENT_ROUNDS:-9} tries=${AGREEMENT_TRIES:-3} pixels=${AGREEMENT_PIXELS:-512} out=$build/agreement
[ -s "$build/this.machine" ] || { echo "agreement: run make calibrate first" >&2; exit 1; }
mkdir -p "$out" || exit 1
[ -s "$out/balls6.ray" ] || "$build/sphereflake" 6 --paper >"$out/balls6.ray" || exit 1
cp scenes/balls5.ray "$out" && cpp -P scenes/room8.ray >"$out/room8.ray" || exit 1
value() { awk -v key="$2" -f tests/support/json_value.awk "$1"; }

each() { # each FUNCTION: FUNCTION NAME SCENE OPTIONS...
  local scene schedule processes
  for scene in balls5 balls6 room8; do
    for schedule in data-parallel hybrid; do
      for processes in 1 2; do
        "$1" "$scene-$schedule-$processes" "$scene" --schedule $schedule --processes $processes \
          --memory 2G --resident 4M --cache 256M -q -R "$pixels" "$pixels"
      done
    done
  done
}
# Seconds of processors in use by anyone, and of a host that takes them away.
in_use() { awk -v hz="$(getconf CLK_TCK)" '/^cpu / { print ($2 + $3 + $4 + $7 + $8 + $9) / hz }' /proc/stat; }
# Of so many runs beside, at once: seconds of one, and how much of a processor other programs took meanwhile.
beside() { # beside RUNS
  local before i TIMEFORMAT='%R %U %S'
  before=$(in_use) && rm -f "$out"/beside.*.json
  {
    time {
      for ((i = 1; i <= $1; i++)); do
        "$build/rayshade" -q -R 512 512 --stats "$out/beside.$i.json" -O "$out/beside.$i.png" "$build/calibrate/balls4.ray" &
      done
      wait
    }
  } 2>"$out/beside.time"
  for ((i = 1; i <= $1; i++)); do value "$out/beside.$i.json" trace_seconds || exit 1; done |
    awk -v used="$(in_use)" -v before="$before" -v times="$(cat "$out/beside.time")" \
      '{ sum += $1 } END { split(times, t, " "); print sum / NR, (used - before - t[2] - t[3]) / t[1] }'
}
at_once() { # NAME, which ends with the number of trace processes
  local processors; processors=$(nproc)
  echo $((${1##*-} < processors ? ${1##*-} : processors))
}
measure() {
  local name=$1 scene=$2 runs=$(at_once "$1") i try before after; shift 2
  for ((i = 1; i <= rounds; i++)); do
    for ((try = 1; try <= tries; try++)); do
      before=$(beside "$runs") || exit 1
      "$build/prayshade" "$@" --stats "$out/$name.$i.json" -O "$out/$name.png" "$out/$scene.ray" || exit 1
      after=$(beside "$runs") || exit 1
      awk -v a="${before#* }" -v b="${after#* }" 'BEGIN { exit !(a <= .2 && b <= .2) }' && break
    done
    awk -v seconds="$(value "$out/$name.$i.json" trace_seconds)" -v a="${before% *}" -v b="${after% *}" -v disturbed=$((try > tries)) \
      'BEGIN { printf "%.6f %.6f %s\n", seconds / ((a + b) / 2), seconds, disturbed ? "disturbed" : "alone" }' >>"$out/$name.times"
  done
}
simulate() {
  local name=$1 scene=$2; shift 2
  "$build/prayshade-sim" "$@" --machine "$build/this.machine" --stats "$out/$name-sim.json" -O "$out/$name-sim.png" "$out/$scene.ray" || exit 1
}

failures=0
bar() { # bar NAME WHAT REAL... SIMULATED PERCENT: as many real figures as there are
  local name=$1 what=$2 percent=${*: -1} simulated=${*: -2:1}
  printf '%s\n' "${@:3:$#-4}" | sort -g | awk -v name="$name" -v what="$what" -v simulated="$simulated" -v percent="$percent" '
    { value[NR] = $1; sum += $1 }
    END {
    real = what == "trace_seconds" ? value[int((NR + 1) / 2)] : sum / NR
    off = real == simulated ? 0 : real == 0 ? 100 : 100 * (simulated / real - 1)
    met = percent == 0 ? value[1] == simulated && value[NR] == simulated : off <= percent && off >= -percent
    printf "%-26s %-14s %12.6g %12.6g %+7.1f%%  %s%s\n", name, what, real, simulated, off,
      (met ? "" : "NOT ") (percent == 0 ? "equal" : "within " percent "%"),
      value[1] < value[NR] ? sprintf("  (%.6g to %.6g)", value[1], value[NR]) : ""
    exit !met }' || failures=$((failures + 1))
}
compare() {
  local name=$1 key percent=10
  bar "$name" trace_seconds $(told_beside "$name") "$(value "$out/$name-sim.json" trace_seconds)" 20
  [[ $name != *data-parallel* ]] || percent=0
  for key in rays.primary rays.shadow rays.reflected operations.hits operations.shadow_hits forwarded_rays; do
    bar "$name" "${key#*.}" $(of_rounds value "$name" $key) "$(value "$out/$name-sim.json" $key)" $percent
  done
  for key in messages bytes_sent; do
    bar "$name" $key $(of_rounds traced "$name" $key) "$(traced "$out/$name-sim.json" $key)" 10
  done
}
told_beside() { # real times, in proportion to what is told of the runs beside
  awk -v told="$(value "$out/beside-sim.json" sequential_seconds)" -v runs="$(at_once "$1")" '
    FILENAME == ARGV[1] { if ($1 == "contention") told *= 1 + $2 * (runs - 1); next }
    { print told * $1 }' "$build/this.machine" "$out/$1.times"
}
of_rounds() { # of_rounds FUNCTION NAME KEY
  local json
  for json in "$out/$2".[0-9]*.json; do "$1" "$json" "$3"; done
}
# What was sent while tracing: the whole without the distribution of the objects.
traced() {
  awk -v a="$(value "$1" "$2")" -v b="$(value "$1" "sent_by_kind.Objects.${2%_sent}")" \
    -v c="$(value "$1" "sent_by_kind.ObjectsTaken.${2%_sent}")" 'BEGIN { print a - b - c }'
}

if [ "$phase" = all ] || [ "$phase" = measure ]; then
  rm -f "$out"/*.times "$out"/*.[0-9]*.json
  [ -n "${PVM_VMID:-}" ] || export PVM_VMID=agreement$$
  each measure
fi
if [ "$phase" = all ] || [ "$phase" = simulate ]; then
  cp "$build/calibrate/balls4.ray" "$out/beside.ray" && simulate beside beside --processes 1 -q -R 512 512 && each simulate
fi
if [ "$phase" = all ] || [ "$phase" = compare ]; then
  printf '%-26s %-14s %12s %12s %8s\n' run what real simulated off
  each compare
  grep -h disturbed "$out"/*.times | awk 'END { if (NR > 0) print "beside " NR " real runs other programs took over a fifth of a processor" }'
  [ $failures = 0 ] && echo "all bars are met" || echo "$failures bars are not met"
fi
exit $((failures > 0))
