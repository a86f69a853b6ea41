#!/bin/bash
# `make demo`: the balls by the sequential renderer and by every schedule, side by side: demo.sh BUILD
# Runs in a virtual machine of its own (pvm_conf/private-vm), which is gone afterwards. Pictures and statistics stay in
# BUILD/demo. DEMO_SIZE (pixels, default 512), DEMO_PROCESSES (default 4) and DEMO_SCENE change what is rendered.
# The status is 0 only where every picture is, byte for byte, the sequential one.
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$(cd "$1" && pwd) || exit 2
if [ "${2:-}" != inside ]; then
  exec pvm_conf/private-vm "$0" "$build" inside
fi

scene=${DEMO_SCENE:-scenes/balls5.ray} size=${DEMO_SIZE:-512} processes=${DEMO_PROCESSES:-4}
out=$build/demo
rm -rf "$out" && mkdir -p "$out" || exit 1

render() { # render NAME PROGRAM OPTIONS...
  local name=$1; shift
  echo "rendering $scene, $size x $size: $name"
  if ! "$@" -q -R "$size" "$size" --stats "$out/$name.json" -O "$out/$name.png" "$scene" >"$out/$name.log" 2>&1; then
    cat "$out/$name.log" >&2
    echo "demo: $name failed" >&2
    exit 1
  fi
}
value() { awk -v key="$2" -f tests/support/json_value.awk "$out/$1.json"; }
row() { # row NAME PROCESSES IDENTICAL
  awk -v name="$1" -v processes="$2" -v identical="$3" -v seconds="$(value "$1" trace_seconds)" \
    -v rays="$(value "$1" rays.total)" -v messages="$(value "$1" messages)" -v bytes="$(value "$1" bytes_sent)" '
    BEGIN { printf "%-14s %9d %8.2f %15.2f %9d %8.2f  %s\n", name, processes, seconds,
      (seconds > 0 ? rays / seconds / 1e6 : 0), messages, bytes / 1e6, identical }'
}

schedules="data-parallel demand-driven hybrid"
render sequential "$build/rayshade"
for schedule in $schedules; do
  render "$schedule" "$build/prayshade" --processes "$processes" --schedule "$schedule"
done

status=0
echo
printf '%-14s %9s %8s %15s %9s %8s  %s\n' schedule processes seconds "million rays/s" messages "MB sent" identical
row sequential 1 -
for schedule in $schedules; do
  identical=yes
  cmp -s "$out/sequential.png" "$out/$schedule.png" || { identical=no; status=1; }
  row "$schedule" "$processes" "$identical"
done
echo
for name in sequential $schedules; do
  echo "$out/$name.png"
done
exit "$status"
