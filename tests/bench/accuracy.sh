#!/bin/bash
# `make accuracy`: measures, writes CHARTS/data/*.csv, draws CHARTS/*.svg and *.png: accuracy.sh BUILD CHARTS [CHART]...
# Programs that are not installed (Tachyon, POV-Ray) are left out with a word, and without gnuplot nothing is drawn.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$1 charts=$2
shift 2
data=$charts/data
mkdir -p "$data" || exit 1

"$build/accuracy" "$data" "$@" || exit 1
"$build/precision" "$data" || exit 1
tests/bench/other_programs.sh "$build" "$data" || exit 1

if ! command -v gnuplot >/dev/null 2>&1; then
  echo "gnuplot is not installed (make deps): the data are written, the charts are not drawn"
  exit 0
fi

draw() { # draw NAME TITLE: every curve of NAME.csv
  local name=$1 title=$2 file=$data/$1.csv
  [ -s "$file" ] || return 0
  awk -F, -v name="$name" -v title="$title" -f tests/bench/plot.awk "$file" >"$build/$name.gnuplot" &&
  for terminal in svg png; do
    gnuplot -e "terminal='$terminal'; out='$charts/$name.$terminal'" "$build/$name.gnuplot" || exit 1
  done
}
