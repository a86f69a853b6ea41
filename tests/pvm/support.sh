# For tests/pvm/*_test.sh, by `.`, after shell_checks.sh: a virtual machine of the test's own, a small scene, and what is
# left running. Nothing here meets a user's virtual machine: name and folder are the test's.
prayshade=$BUILD/prayshade
rayshade=$BUILD/rayshade
export PVM_ROOT=${PVM_ROOT:-/usr/lib/pvm3} PVM_VMID=test$$ PVM_TMP=$work/pvm
mkdir "$PVM_TMP"
[ "$(id -u)" != 0 ] || export PVM_ALLOW_ROOT=1

need_pvm() { # need_pvm SENTENCE
  command -v pvmd >/dev/null 2>&1 && return
  skip "$1" "PVM is not installed"
  exit 0
}

cat >"$work/small.ray" <<END
screen 48 48
eyep 0 -8 3
light 1 point 4 -8 8
light .4 directional -1 -1 2
surface shiny diffuse .8 .1 .1 specular .5 .5 .5 reflect .3
surface glass diffuse .1 .1 .1 transp .7 index 1.3
surface grey diffuse .5 .5 .5
plane grey 0 0 -1 0 0 1
list
sphere shiny 1 0 0 0
sphere glass .6 1.5 -1.5 -.2
box shiny -2 -1 -1 -1.2 0 1
cylinder grey .3 -1 2 -1 -1 2 1.5
triangle grey -3 3 -1 3 3 -1 0 3 3
end
END
# Some minutes of work.
{ echo 'sample 4 nojitter'; echo 'contrast 0 0 0'; grep -vE '^(sample|contrast)' scenes/balls5.ray; } >"$work/long.ray"

# Processes of ours: they have the name of the test's virtual machine in their environment.
ours() { grep -lzs "^PVM_VMID=$PVM_VMID$" /proc/[0-9]*/environ | cut -d/ -f3; }
running() { # running NAME: our processes of that name
  local pid
  for pid in $(ours); do
    [ "$(readlink "/proc/$pid/exe" 2>/dev/null)" = "$BUILD/$1" ] && echo "$pid"
  done
}
waits() { # waits TENTHS COMMAND...: until it succeeds
  local left=$1; shift
  until "$@"; do
    [ $((left -= 1)) -gt 0 ] || return 1
    sleep 0.1
  done
}
has_running() { [ "$(running "$1" | wc -l)" -ge "$2" ]; } # has_running NAME COUNT
nothing_runs() { [ -z "$(running prayshade)$(running prayshade-trace)$(running pvmd)" ]; }
nothing_is_left() {
  waits 20 nothing_runs || { echo "still running: $(running prayshade) $(running prayshade-trace)"; return 1; }
  ! ls -A "$PVM_TMP" | grep .
}
