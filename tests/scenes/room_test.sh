#!/bin/bash
# The conference room: what the issue of it promises, counted in the files.
. "$(dirname "$0")/../support/shell_checks.sh"
"$BUILD/room" >"$work/room.inc"

polygons() { grep -c '^poly ' scenes/room.inc; }
# Every corner of a polygon from lowest to highest x y z, the night before the windows (surface evening) apart.
points_stay_in() {
  awk -v box="$*" 'BEGIN { split(box, limit, " ") }
    $1 == "applysurf" { surface = $2 }
    $1 == "poly" && surface != "evening" { for (i = 2; i <= NF; i++) { a = (i - 2) % 3 + 1
      if ($i < limit[a] || $i > limit[a + 3]) { print "outside:", $0; exit 1 } } }' scenes/room.inc
}
surfaces_are_defined() {
  awk '$1 == "surface" { known[$2] } $1 == "applysurf" && !($2 in known) { print "unknown:", $2; bad = 1 }
    END { exit bad }' scenes/room.inc
}
lights() { cat scenes/room_view.inc "scenes/room$1.ray" | grep -c '^light '; }

check "the committed room is what the generator makes" cmp "$work/room.inc" scenes/room.inc
check "it has more than 20,000 polygons" test "$(polygons)" -gt 20000
check "it stays within 11 x 7 x 2.7 m, window niches of 18 cm besides" points_stay_in 0 0 0 11 7.18 2.7
check "every surface in use is defined" surfaces_are_defined
check "the file says how many polygons it has" grep -q "^/\* $(polygons) polygons \*/" scenes/room.inc
for n in 8 30; do check "room$n.ray has $n point lights" test "$(lights $n)" = $n; done
exit $((failures > 0))
