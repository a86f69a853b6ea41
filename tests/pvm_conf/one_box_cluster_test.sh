#!/bin/bash
# one-box-cluster: real pvmds in network namespaces, a picture rendered over them, and nothing left of them.
. "$(dirname "$0")/../support/shell_checks.sh"
cluster=pvm_conf/one-box-cluster
export ONE_BOX_NAME=test$$ ONE_BOX_FOLDER=$work/cluster
stands="four pvmds in four network namespaces make one virtual machine"

if ! $cluster up 4 >"$work/said" 2>&1; then
  if grep -qE 'not allowed|needs root|is missing|not installed|only on' "$work/said"; then
    skip "$stands" "$(tail -n 1 "$work/said")"
    exit 0
  fi
  check "$stands" cat "$work/said" /nonexistent
  exit 1
fi
trap '$cluster down >/dev/null 2>&1; rm -rf "$work"' EXIT

hosts_in_conf() { [ "$(echo conf | $cluster run pvm | grep -cE "^ *${ONE_BOX_NAME}[0-9] ")" = 4 ]; }
spawns_everywhere() {
  (echo "spawn -4 -> /usr/bin/env"; sleep 1; echo quit) | $cluster run pvm >"$work/spawned"
  [ "$(grep -oE "PVM_TMP=$work/cluster/[^ ]*/${ONE_BOX_NAME}[0-9]" "$work/spawned" | sort -u | wc -l)" = 4 ]
}
value() { awk -v key="$2" -f tests/support/json_value.awk "$1"; }
renders_alike() { # renders_alike SCHEDULE: the sequential picture, by one process on each host
  $cluster run "$BUILD/prayshade" -q -R 100 100 --processes 4 --schedule "$1" --stats "$work/stats.json" \
    -O "$work/parallel.png" "$work/balls.ray" &&
    cmp "$work/sequential.png" "$work/parallel.png" &&
    [ "$(for i in 0 1 2 3 4; do value "$work/stats.json" "processes.$i.host"; done | sort -u | wc -l)" = 4 ]
}
is_gone() {
  ! ip netns list | grep -q "^$ONE_BOX_NAME" && [ ! -e "$ONE_BOX_FOLDER" ] && [ ! -e "/etc/netns/${ONE_BOX_NAME}0" ] &&
    ! grep -lqs "PVM_VMID=$ONE_BOX_NAME" /proc/[0-9]*/environ
}

check "$stands" hosts_in_conf
check "a spawn reaches all four" spawns_everywhere
if [ -x "$BUILD/prayshade" ]; then
  "$BUILD/sphereflake" 3 --paper >"$work/balls.ray"
  "$BUILD/rayshade" -q -R 100 100 -O "$work/sequential.png" "$work/balls.ray"
  for schedule in data-parallel demand-driven hybrid; do
    check "$schedule over four hosts makes the sequential picture" renders_alike "$schedule"
  done
else
  skip "three schedules over four hosts make the sequential picture" "prayshade is not built"
fi
check "status names every host and its link" bash -c "$cluster status | grep -c ', link up, runs: 1 x pvmd' | grep -qx 4"
check "a cut link shows" bash -c "$cluster cut ${ONE_BOX_NAME}2 && $cluster status | grep -q 'link down'"
check "a second cluster of the same name is refused" bash -c "! $cluster up 2 2>/dev/null"
check "down ends it, with a link cut" $cluster down
check "nothing is left" is_gone
exit $((failures > 0))
