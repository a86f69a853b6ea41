#!/bin/bash
# Over PVM the picture is the sequential one, byte for byte; on a virtual machine that prayshade starts and ends itself.
. "$(dirname "$0")/../support/shell_checks.sh" || exit 2
. tests/pvm/support.sh || exit 2
need_pvm "the picture over PVM is the sequential one"

"$rayshade" -q --stats "$work/sequential.json" -O "$work/sequential.png" "$work/small.ray"
same_picture() { # same_picture SCHEDULE PROCESSES
  rm -f "$work/parallel.png"
  timeout 60 "$prayshade" -q --schedule "$1" --processes "$2" --stats "$work/parallel.json" -O "$work/parallel.png" \
    "$work/small.ray" && cmp "$work/sequential.png" "$work/parallel.png"
}
value() { awk -v key="$2" -f tests/support/json_value.awk "$work/$1.json"; }
processes_reported() { [ "$(grep -o '"id":[0-9]*' "$work/parallel.json" | sort -u | wc -l)" = "$1" ]; }

for schedule in data-parallel demand-driven hybrid; do
  for processes in 1 3; do
    check "$schedule on $processes makes the sequential picture" same_picture $schedule $processes
    check "$schedule on $processes reports every process" processes_reported $processes
  done
done
check "no message is uncounted" test "$(value parallel messages)" -gt 20

frames() { # frames PROGRAM NAME
  timeout 60 "$@" -q -N 3 "$work/small.ray"
}
check "three frames sequentially" frames "$rayshade" -O "$work/s.png"
check "three frames by the same processes" frames "$prayshade" --processes 2 -O "$work/p.png"
for number in 0000 0001 0002; do
  check "frame $number is the sequential one" cmp "$work/s.$number.png" "$work/p.$number.png"
done

compares() {
  timeout 60 "$prayshade" -q --processes 2 --compare -O "$work/c.png" "$work/small.ray" >"$work/table" &&
    grep -q '^pictures: identical$' "$work/table" && grep -qE '^speed-up .* [0-9.]+$' "$work/table"
}
check "--compare renders sequentially as well and finds the pictures identical" compares
check "nothing is left" nothing_is_left
exit $((failures > 0))
