#!/bin/bash
# `make accuracy`: measures, writes CHARTS/data/*.csv, draws CHARTS/*.svg and *.png, and lists what is worth using in
# CHARTS/README.md: accuracy.sh BUILD CHARTS [CHART]...  (with CHART: measures only those, of build/accuracy's)
# Programs that are not installed (Tachyon, POV-Ray) are left out with a word, and without gnuplot nothing is drawn.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$1 charts=$2
shift 2
data=$charts/data
mkdir -p "$data" || exit 1

if [ $# -gt 0 ]; then
  "$build/accuracy" "$data" "$@" || exit 1
else
  "$build/accuracy" "$data" || exit 1
  "$build/precision" "$data" || exit 1
  tests/bench/other_programs.sh "$build" "$data" || exit 1
fi

# NAME|TITLE of every chart, in the order of the list.
catalogue='antialiasing-balls|Antialiasing: balls5, fractal detail everywhere
antialiasing-room|Antialiasing: the room with 8 lights
antialiasing-first|Antialiasing: first.ray, a checkered floor to the horizon
area|An area light: which cells of it a sample asks
extended|An extended light: samples of a pixel spread over it
light-cutoff|30 lights: those that could add less than the limit arrive untested
depth-balls|Depth limit and cutoff: balls5 (64 samples per pixel)
depth-mirrors|Depth limit and cutoff: mirrors that face each other, and glass (64 samples per pixel)
precision|Single against double precision: balls5 in a small tracer of its own
others-balls|Other programs: balls5'

if command -v gnuplot >/dev/null 2>&1; then
  while IFS='|' read -r name title; do
    [ -s "$data/$name.csv" ] || continue
    awk -F, -v title="$title" -v x="tracing time (1 = one plain sample per pixel)" -f tests/bench/plot.awk "$data/$name.csv" \
      >"$build/$name.gnuplot" || exit 1
    for terminal in svg png; do
      gnuplot -e "terminal='$terminal'; out='$charts/$name.$terminal'" "$build/$name.gnuplot" || exit 1
    done
  done <<<"$catalogue"
else
  echo "gnuplot is not installed (make deps): the data are written, the charts are not drawn"
fi

{
  cat tests/bench/charts_head.md
  while IFS='|' read -r name title; do
    [ -s "$data/$name.csv" ] || continue
    awk -F, -v name="$name" -v title="$title" -f tests/bench/worth_using.awk "$data/$name.csv" || exit 1
  done <<<"$catalogue"
} >"$charts/README.md"
echo "written: $charts/README.md, its charts and their data"
