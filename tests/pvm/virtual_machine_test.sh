#!/bin/bash
# Which virtual machine prayshade uses: a running one, the console's, or its own; and what it says where there is none.
. "$(dirname "$0")/../support/shell_checks.sh" || exit 2
. tests/pvm/support.sh || exit 2
need_pvm "prayshade in a virtual machine"
"$rayshade" -q -O "$work/sequential.png" "$work/small.ray"
small() { timeout 60 "$@" -q --processes 2 -O "$work/a.png" "$work/small.ray"; }
same() { cmp "$work/sequential.png" "$work/a.png"; }
said() { grep -qE -- "$1" "$work/said" || { cat "$work/said"; return 1; }; }
refused() { # refused COMMAND...: status 1, no picture
  rm -f "$work/a.png"
  "$@" >"$work/said" 2>&1
  [ $? = 1 ] && [ ! -e "$work/a.png" ]
}

# A name that the user has given, and none.
check "a run without a virtual machine makes its own" small "$prayshade"
check "nothing of it is left" nothing_is_left
check "one without PVM_VMID and PVM_TMP as well" small env -u PVM_VMID -u PVM_TMP TMPDIR="$work/pvm" "$prayshade"
check "nothing of it is left either" nothing_is_left

# A virtual machine that runs already.
inside() { # in one virtual machine: two runs, then how many hosts and tasks there are
  small "$prayshade" && small "$prayshade" && echo "ps -a" | pvm >"$work/tasks" && same
}
export -f small inside same
export prayshade work
check "a running virtual machine is used and goes on" pvm_conf/private-vm bash -c inside
check "no task is left in it" bash -c "! grep -q prayshade '$work/tasks'"

console() {
  rm -f "$work/a.png"
  (echo "spawn -> $prayshade -q --processes 2 -O $work/a.png $work/small.ray"
   for _ in $(seq 200); do [ -e "$work/a.png" ] && break; sleep 0.1; done
   sleep 0.3; echo quit) | timeout 60 pvm >"$work/console"
}
export -f console
check "the console of a virtual machine can spawn it" pvm_conf/private-vm bash -c console
check "and the picture is the sequential one" same

# What is missing.
check "without PVM it ends with an error" refused env PATH=/nowhere PVM_ROOT=/nowhere "$prayshade" -q -O "$work/a.png" \
  "$work/small.ray"
check "which says in one line what to install" said '^[^ ]*prayshade: Error: PVM is not installed.*apt-get install pvm'
mkdir "$work/alone" && cp "$prayshade" "$work/alone"
check "without prayshade-trace it ends with an error" refused env HOME="$work" "$work/alone/prayshade" -q --processes 2 \
  -O "$work/a.png" "$work/small.ray"
check "which says how many were asked for and where it looked" said 'prayshade-trace.*asked 2, got 0.*no such file'
crowd() (
  ulimit -n 24
  exec "$prayshade" -q --processes 40 -O "$work/a.png" "$work/small.ray"
)
check "fewer processes than asked are an error" refused crowd
check "which names both numbers" said 'asked 40, got [0-9]+:'
check "prayshade-trace by hand says what it is for" bash -c "'$BUILD/prayshade-trace' 2>&1 | grep -q 'started by prayshade'"
check "nothing is left" nothing_is_left
exit $((failures > 0))
