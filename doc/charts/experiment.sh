# For the experiments of this folder, by `.`: scenes, simulated runs, and how many at once.
# Each script is called as SCRIPT BUILD from the root of the repository (`make table1 figures map sensitivity`).
# RAYSHADE_SHARED (default ../shared): where scenes/conference8.ray.gz and conference30.ray.gz stand, if anywhere; else the
# room is the project's own. JOBS: runs at once (default: one for each processor).
set -u
charts=doc/charts data=doc/charts/data
jobs=${JOBS:-$(nproc)}
shared=${RAYSHADE_SHARED:-../shared}
export LC_ALL=C

value() { awk -v key="$2" -f tests/support/json_value.awk "$1"; }

# Writes balls5.ray, room8.ray and room30.ray to $out; $room says which room that is.
make_scenes() {
  local n
  cp scenes/balls5.ray "$out" || exit 1
  room=own
  [ ! -r "$shared/scenes/conference8.ray.gz" ] || room=real
  for n in 8 30; do
    if [ "$room" = real ]; then
      gunzip -c "$shared/scenes/conference$n.ray.gz"
    else
      cpp -P "scenes/room$n.ray"
    fi >"$out/room$n.ray" || exit 1
  done
}
room_name() { [ "$1" = own ] && echo "the project's own room" || echo "the conference room of Grynberg and Ward (LBL)"; }

# run NAME SCENE-FILE OPTIONS...: simulates to $out/NAME.json; prints "done", or "o.m." where memory is not enough.
run() {
  local name=$1 scene=$2; shift 2
  if "$build/prayshade-sim" -q --distribution grid "$@" --stats "$out/$name.json" -O "$out/$name.png" "$scene" >"$out/$name.log" 2>&1; then
    echo "done"
  elif grep -q 'out of memory' "$out/$name.log"; then
    echo "o.m."
  else
    cat "$out/$name.log" >&2
    return 1
  fi
}

# in_parallel LINES SCRIPT: each line of standard input as arguments of `SCRIPT BUILD one`; fails where one of them does.
in_parallel() { xargs -P "$jobs" -L 1 "$1" "$build" one; }

# draw NAME: gnuplot draws NAME.gnuplot as NAME.svg and NAME.png.
draw() {
  local name=$1 size=${2:-1200,500}
  gnuplot -e "set terminal svg size $size font 'Helvetica,14' background 'white'; set output '$charts/$name.svg'" "$charts/$name.gnuplot" &&
    gnuplot -e "set terminal pngcairo size $size font 'Helvetica,11'; set output '$charts/$name.png'" "$charts/$name.gnuplot" || exit 1
  echo "$charts/$name.svg $charts/$name.png"
}
