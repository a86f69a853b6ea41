#!/bin/bash
# `make lint`: who may include whom, by folder (doc/architecture.md), and the format where clang-format is installed.
# Dependencies point one way. Prints each line that breaks a rule; the status is 0 where none does.
set -u
cd "$(dirname "$0")/../.." || exit 2

bad=$(grep -rnE '^#include ["<]' rayshade parallel scenes --include='*.cc' --include='*.h' --include='*.y' --include='*.l' | awk '
  function allow(folder, others,   n, list, i) {
    n = split(others, list, " ")
    for (i = 1; i <= n; i++) allowed[folder, list[i]]
  }
  function folder_of(path,   part, n) { # rayshade/geom/a.h: rayshade/geom; rayshade/main.cc: rayshade
    n = split(path, part, "/")
    return n > 2 ? part[1] "/" part[2] : part[1]
  }
  BEGIN {
    c = "rayshade/common"
    allow("rayshade/geom", c)
    allow("rayshade/surface", c)
    allow("rayshade/light", c " rayshade/geom")
    allow("rayshade/texture", c " rayshade/geom rayshade/surface")
    allow("rayshade/image", c " rayshade/texture")
    allow("rayshade/accel", c " rayshade/geom")
    below_scene = c " rayshade/geom rayshade/surface rayshade/light rayshade/texture rayshade/image rayshade/accel"
    allow("rayshade/scene", below_scene)
    allow("rayshade/shade", below_scene " rayshade/scene")
    core = below_scene " rayshade/scene rayshade/shade"
    allow("rayshade/render", core)
    allow("rayshade", core " rayshade/render")
    allow("parallel", core " rayshade/render")
    allow("parallel/pvm", core " rayshade/render parallel")
    allow("parallel/sim", core " rayshade/render parallel")
    # Single files, each with its reason.
    single["rayshade/accel/object_set.h", "rayshade/scene/scene.h"]       # a set of objects is a set of placements
    single["rayshade/surface/atmosphere.cc", "rayshade/texture/noise.h"]  # a fog deck is made of noise
  }
  {
    split($0, part, ":")
    file = part[1]
    match($0, /["<][^">]+/)
    name = substr($0, RSTART + 1, RLENGTH - 1)
    if (name == "png.h" && file != "rayshade/image/png.cc") { print; next }
    if (name == "pvm3.h" && file !~ /^parallel\/pvm\//) { print; next }
    if (name !~ /^(rayshade|parallel)\//) next
    from = folder_of(file); to = folder_of(name)
    if (from == to || from == "scenes" || (from, to) in allowed || (file, name) in single) next
    print
  }')
status=0
if [ -n "$bad" ]; then
  echo "Includes that point the wrong way:"
  echo "$bad"
  status=1
fi

if command -v clang-format >/dev/null 2>&1; then
  unformatted=$(git ls-files '*.cc' '*.h' | xargs clang-format --dry-run 2>&1 | sed -nE 's|^([^: ]+):[0-9]+:[0-9]+: warning.*|\1|p' | sort -u)
  if [ -n "$unformatted" ]; then
    echo "Not in the project's format (clang-format -i):"
    echo "$unformatted"
    status=1
  fi
else
  echo "clang-format is not installed: the format was not looked at"
fi
[ "$status" != 0 ] || echo "nothing to complain of"
exit "$status"
