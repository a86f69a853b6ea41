#!/bin/bash
# The sphereflake generator: counts, bounds and, where it is there, a listing by the original generator.
. "$(dirname "$0")/../support/shell_checks.sh"
flake=$BUILD/sphereflake

# Radius and centre of each sphere, surface name or not.
spheres() { awk '$1 == "sphere" { print $(NF-3), $(NF-2), $(NF-1), $NF }' "$1"; }
sphere_count_is() { [ "$("$flake" "$1" | grep -c '^sphere')" = "$2" ]; }

bounds() {
  spheres "$1" | awk '
    { for (a = 1; a <= 3; a++) { l = $(a+1) - $1; h = $(a+1) + $1
        if (NR == 1 || l < low[a]) low[a] = l; if (NR == 1 || h > high[a]) high[a] = h } }
    END { printf "%.5f %.5f %.5f %.5f %.5f %.5f\n", low[1], low[2], low[3], high[1], high[2], high[3] }'
}
bounds_are() {
  local found; found=$(bounds "$1"); shift
  echo "$found" "$@" | awk '{ print; for (i = 1; i <= 6; i++) { d = $i - $(i+6); if (d > 2e-5 || d < -2e-5) exit 1 } }'
}

# Every sphere of either file has one of the other within the rounding of the sixth digit, and no two share one.
same_spheres() {
  spheres "$1" >"$work/a" && spheres "$2" >"$work/b"
  awk 'function far(x, y) { return x - y > 1.6e-6 || y - x > 1.6e-6 }
    NR == FNR { for (k = 1; k <= 4; k++) p[NR, k] = $k; n = NR; next }
    { m++; found = 0
      for (i = 1; i <= n && !found; i++)
        if (!(i in used) && !far(p[i,4], $4) && !far(p[i,3], $3) && !far(p[i,2], $2) && !far(p[i,1], $1)) { used[i]; found = 1 }
      if (!found) { print "no partner for", $0; exit 1 } }
    END { if (n != m) { print n, "and", m, "spheres"; exit 1 } }' "$work/a" "$work/b"
}

for size in 0 1 2 3 4; do
  check "size $size has (9^$((size + 1)) - 1) / 8 balls" sphere_count_is "$size" $(((9 ** (size + 1) - 1) / 8))
done
"$flake" 5 --paper >"$work/5.ray"
check "the committed balls5.ray is what the generator makes" cmp "$work/5.ray" scenes/balls5.ray
check "balls5 fills the published bounds" bounds_are "$work/5.ray" -.940876 -.940876 -.5 .954125 .954125 .833425
check "the paper's ten largest balls are dull, and no others" test "$(grep -c '^sphere dull' "$work/5.ray")" = 10
check "a bad size is refused with the usage" bash -c "! '$flake' three 2>'$work/said' && grep -q usage '$work/said'"
"$flake" 1 >/dev/full 2>/dev/null
check "a full disk is an error" test $? != 0

listing=$shared/scenes/balls3.ray.gz
same="size 3 is the original generator's listing to six digits"
if [ -r "$listing" ]; then
  gzip -dc "$listing" >"$work/original.ray"
  "$flake" 3 --lights 3 --plane >"$work/ours.ray"
  check "$same" same_spheres "$work/original.ray" "$work/ours.ray"
else
  skip "$same" "no $listing"
fi
exit $((failures > 0))
