#!/bin/bash
# Every scene of the project renders, without a word on standard error; so does the one that README.md shows.
. "$(dirname "$0")/../support/shell_checks.sh"
renders() {
  "$BUILD/rayshade" -q -R 48 48 -S 1 -O "$work/a.png" "$1" 2>"$work/said" && [ ! -s "$work/said" ] && [ -s "$work/a.png" ] && return
  cat "$work/said"
  return 1
}
for scene in scenes/*.ray; do check "$scene renders without a word" renders "$scene"; done
sed -n '/^## A first scene/,/^and render/s/^    //p' README.md >"$work/mine.ray"
check "README's own scene renders without a word" renders "$work/mine.ray"
exit $((failures > 0))
