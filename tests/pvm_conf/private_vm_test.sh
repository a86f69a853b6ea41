#!/bin/bash
# private-vm: a virtual machine for one command, and nothing left of it.
. "$(dirname "$0")/../support/shell_checks.sh"
command -v pvmd >/dev/null 2>&1 || { skip "a private virtual machine" "PVM is not installed"; exit 0; }
export TMPDIR=$work

# The folder and the name of the virtual machine that a command ran in.
told() { sed -n "s/^$1 //p" "$work/said"; }
# No process has the name of the virtual machine in its environment.
no_process_of() { ! grep -lqs "PVM_VMID=$1" /proc/[0-9]*/environ; }

pvm_conf/private-vm bash -c 'echo "name $PVM_VMID"; echo "folder $PVM_TMP"; echo conf | pvm; exit 7' \
  >"$work/said" 2>&1
status=$?
check "the command's status is the status" test $status = 7
check "the command finds a virtual machine of one host" grep -q '^1 host, ' "$work/said"
check "its folder is removed" test ! -e "$(told folder)"
check "no process is left" no_process_of "$(told name)"

pvm_conf/private-vm sh -c 'echo "name $PVM_VMID"; echo "folder $PVM_TMP"; exec sleep 60' >"$work/said" 2>&1 &
running=$!
for _ in $(seq 50); do [ -n "$(told folder)" ] && break; sleep 0.1; done
kill $running
wait $running 2>/dev/null
check "an interrupted run is halted too" test ! -e "$(told folder)"
check "and leaves no process either" no_process_of "$(told name)"
exit $((failures > 0))
