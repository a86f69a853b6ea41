#!/bin/bash
# Counts instructions (count.sh) of this tree and of the commit before it, built here and now, and fails where a scene
# takes over 3% more and doc/performance.md does not say why: compare_counts.sh BUILD
# The commit before: BENCH_BASE, or where the branch left origin/main, or on main itself the parent. A reason is a row
#   | bench-count | SCENE | at most +5% | why |
# that doc/performance.md has got since that commit; the growth that it allows is the one that it names.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$(cd "$1" && pwd) || exit 2
skip() { echo "bench-count: not compared: $*"; exit 0; }

base=${BENCH_BASE:-}
[ -n "$base" ] || base=$(git merge-base HEAD origin/main 2>/dev/null)
head=$(git rev-parse HEAD 2>/dev/null) || skip "this is no clone"
if [ -z "${BENCH_BASE:-}" ] && { [ -z "$base" ] || [ "$base" = "$head" ]; }; then
  base=$(git rev-parse -q --verify HEAD^) || { git fetch -q --deepen=1 2>/dev/null; base=$(git rev-parse -q --verify HEAD^); } ||
    skip "there is no commit before this one"
fi
base=$(git rev-parse -q --verify "$base^{commit}") || skip "there is no commit ${BENCH_BASE:-}"

old=$build/base
if [ "$(cat "$old/commit" 2>/dev/null)" != "$base" ]; then
  rm -rf "$old" && mkdir -p "$old" && git archive "$base" | tar -x -C "$old" || exit 1
  env -u MAKEFLAGS -u MFLAGS make -C "$old" -j"$(nproc)" BUILD=build build/rayshade >"$old/log" 2>&1 || skip "$base does not build here (see $old/log)"
  echo "$base" >"$old/commit"
fi
tests/bench/count.sh "$old/build/rayshade" "$build/count" >"$build/count/before" || skip "$base cannot render the scenes"
tests/bench/count.sh "$build/rayshade" "$build/count" >"$build/count/after" || exit 1

echo "instructions, thousands: before (${base:0:9}), now"
join "$build/count/before" "$build/count/after" | awk -v before="$old/doc/performance.md" -v now=doc/performance.md '
  BEGIN {
    while ((getline line <before) > 0) known[line] = 1
    while ((getline line <now) > 0) {
      if (line in known || split(line, f, / *\| */) < 5 || f[2] != "bench-count" || f[5] == "") continue
      limit = f[4]
      gsub(/[^0-9.]/, "", limit)
      allowed[f[3]] = limit + 0  # a number, or 10 would come before 3
    }
  }
  {
    growth = 100 * ($3 / $2 - 1)
    most = ($1 in allowed) && allowed[$1] > 3 ? allowed[$1] : 3
    verdict = growth <= most ? "ok" : "TOO MUCH, and doc/performance.md does not say why"
    if (growth > most) bad = 1
    printf "%-24s %10.0f %10.0f  %+6.2f%%  %s\n", $1, $2 / 1000, $3 / 1000, growth, verdict
  }
  END { exit bad }'
