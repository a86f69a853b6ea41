#!/bin/bash
# Feeds the parser with libFuzzer: fuzz.sh PROGRAM WORK RUNS [FOLDER WITH SCENES]
# The corpus in WORK/corpus begins with the scenes of the folder (`make fuzz`: the reference scenes where they are
# there, else those of scenes/) and is kept from run to run; the dictionary is made of the parser's keywords.
# A crash, hang, leak or error of a sanitizer ends the run with another status than 0; its input is left in WORK.
set -u
cd "$(dirname "$0")/../.." || exit 2
program=$(realpath "$1") && mkdir -p "$2/corpus" && work=$(cd "$2" && pwd) || exit 2
runs=$3
scenes=${4:-scenes}

sed -nE 's/^ *\{"([^"]+)", T_.*/"\1"/p' rayshade/scene/keywords.cc >"$work/keywords.dict"
find "$scenes" -name '*.ray' -size -16k | while read -r scene; do
  cp "$scene" "$work/corpus/$(basename "$scene")"
done
echo "corpus: $(find "$work/corpus" -type f | wc -l) files, scenes from $scenes"
echo "dictionary: $(wc -l <"$work/keywords.dict") keywords"

# Files that a scene names are looked for in an empty folder.
mkdir -p "$work/empty" && cd "$work/empty" || exit 2
"$program" -runs="$runs" -dict="$work/keywords.dict" -artifact_prefix="$work/" -max_len=8192 -timeout=60 \
  -rss_limit_mb=2048 -print_final_stats=1 "$work/corpus" >"$work/log" 2>&1
status=$?
grep -E '^stat::(number_of_executed_units|average_exec_per_sec|new_units_added|slowest_unit|peak_rss)' "$work/log"
if [ "$status" = 0 ]; then
  echo "no crash, hang, leak or error of a sanitizer"
else
  grep -E '^(==[0-9]+==|SUMMARY|.*runtime error)' "$work/log" | head -5
  echo "the input is kept in $work; see $work/log"
fi
exit "$status"
