#!/bin/bash
# The scenes of `make bench-count`: prepare_counts.sh SPHEREFLAKE FOLDER
set -eu
rm -rf "$2" && mkdir -p "$2"
"$1" 3 --paper >"$2/balls3.ray"
"$1" 4 --paper | sed 's/^screen.*/crop 0 .1 0 .1/' >"$2/parsing.ray"  # 7,381 spheres, hardly a pixel
cpp -P scenes/room8.ray >"$2/room8.ray"
for scene in aggregate-csg-nested light-area texture-marble; do cp "scenes/gallery/$scene.ray" "$2"; done
cp scenes/gallery/land.map "$2"
