#!/bin/bash
# One picture over four PVM hosts, each in a network of its own.
. "$(dirname "$0")/../support/shell_checks.sh" || exit 2
. tests/pvm/support.sh || exit 2
sentence="four PVM hosts make the sequential picture"
need_pvm "$sentence"
cluster=pvm_conf/one-box-cluster
[ -x $cluster ] || { skip "$sentence" "there is no $cluster"; exit 0; }
unset PVM_VMID PVM_TMP
export ONE_BOX_NAME=ray$$ ONE_BOX_FOLDER=$work/cluster
if ! $cluster up 4 >"$work/said" 2>&1; then
  if grep -qE 'not allowed|needs root|is missing|not installed|only on' "$work/said"; then
    skip "$sentence" "$(tail -n 1 "$work/said")"
    exit 0
  fi
  check "$sentence" cat "$work/said" /nonexistent
  exit 1
fi
trap '$cluster down >/dev/null 2>&1; rm -rf "$work"' EXIT

"$rayshade" -q -O "$work/sequential.png" "$work/small.ray"
over_four_hosts() { # over_four_hosts SCHEDULE
  rm -f "$work/a.png"
  timeout 60 $cluster run "$prayshade" -q --schedule "$1" --processes 8 --stats "$work/stats.json" -O "$work/a.png" \
    "$work/small.ray" && cmp "$work/sequential.png" "$work/a.png"
}
two_on_each() {
  [ "$(grep -oE '"host":"[^"]*"' "$work/stats.json" | sort | uniq -c | awk '$1 == 2' | wc -l)" = 4 ]
}
for schedule in data-parallel demand-driven hybrid; do
  check "$sentence: $schedule" over_four_hosts $schedule
done
check "every host gets its share of the processes" two_on_each

# A machine that vanishes: its link is cut, PVM itself would take minutes to notice.
lost_machine() {
  local host status
  $cluster run "$prayshade" -q -R 1200 1200 --processes 4 -O "$work/b.png" "$work/long.ray" >"$work/said" 2>&1 &
  host=$!
  sleep 4
  $cluster cut "${ONE_BOX_NAME}2"
  waits 500 bash -c "! kill -0 $host 2>/dev/null" || kill -9 $host
  wait $host; status=$?
  [ $status = 1 ] && grep -q "nothing was heard from ${ONE_BOX_NAME}2" "$work/said" && [ ! -e "$work/b.png" ] ||
    { echo "status $status"; cat "$work/said"; return 1; }
}
if [ -n "${SLOW_TESTS:-}" ]; then
  check "a machine that vanishes ends the run within its lease" lost_machine
else
  skip "a machine that vanishes ends the run within its lease" "takes 40 seconds; SLOW_TESTS=1 runs it"
fi
exit $((failures > 0))
