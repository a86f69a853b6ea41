#!/bin/bash
# `make bench-count`: instructions that the renderer takes for small scenes, counted by callgrind: count.sh PROGRAM FOLDER
# Repeatable to the digit on one machine: plain kernels, a bare environment, scenes named alike. The C library chooses
# other code on other processors, so counts of two programs are compared on one machine only (compare_counts.sh).
# FOLDER holds the scenes; prepare_counts.sh makes it. Prints: SCENE COUNT.
set -u
program=$(realpath "$1") || exit 2
cd "$2" || exit 2
for scene in *.ray; do
  cp "$program" ./count-this || exit 1
  env -i PATH=/usr/bin:/bin RAYSHADE_SIMD=plain valgrind --tool=callgrind --callgrind-out-file=/dev/null \
    ./count-this -q -R 48 48 -O count.png "$scene" >count.log 2>&1 || { cat count.log >&2; exit 1; }
  awk -v scene="${scene%.ray}" '/Collected *:/ { print scene, $NF }' count.log
done
