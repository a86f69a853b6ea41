#!/bin/bash
# A run that is cut short, by the loss of a process or by a signal, ends within seconds; nothing is left running, no
# picture and no part of one is written.
. "$(dirname "$0")/../support/shell_checks.sh" || exit 2
. tests/pvm/support.sh || exit 2
need_pvm "a run that is cut short"

host= status=
start() { # a long run in the background, until both trace processes are at work
  rm -f "$work/a.png"
  env --default-signal=INT "$prayshade" "$@" -q -R 1200 1200 --processes 2 -O "$work/a.png" "$work/long.ray" \
    >"$work/said" 2>&1 &
  host=$!
  waits 200 has_running prayshade-trace 2 && sleep 1
}
end() { # fills in the status; a run that does not end within five seconds is killed
  local left=50
  while kill -0 $host 2>/dev/null && [ $((left -= 1)) -gt 0 ]; do sleep 0.1; done
  [ $left -gt 0 ] || kill -9 $host
  wait $host 2>/dev/null
  status=$?
  [ $left -gt 0 ] || status="none within five seconds"
}
is() { [ "$status" = "$1" ] || { echo "status $status"; cat "$work/said"; return 1; }; }
said() { grep -qE -- "$1" "$work/said" || { cat "$work/said"; return 1; }; }
no_picture() { [ ! -e "$work/a.png" ] && ! ls "$work" | grep -v partial | grep 'a\.png'; }

for schedule in data-parallel demand-driven hybrid; do
  start --schedule $schedule
  kill -9 "$(running prayshade-trace | tail -1)"
  end
  check "$schedule: a killed trace process ends the run with status 1" is 1
  check "$schedule: the message names the process and its machine" said 'process [12].*127\.0\.0\.1'
  check "$schedule: there is no picture" no_picture
  check "$schedule: nothing is left" nothing_is_left
done

start
kill -INT $host
end
check "SIGINT ends the run with status 130" is 130
check "and says what is kept" said 'Interrupted'
check "there is no picture" no_picture
check "nothing is left" nothing_is_left

# What was finished is kept, and -c goes on from there to the very picture of an undisturbed run.
grown="-S 1 -R 1200 1200"
"$rayshade" -q $grown -O "$work/whole.png" "$work/long.ray"
goes_on() { "$prayshade" -q -c --processes 2 $grown -O "$work/a.png" "$work/long.ray"; }
rm -f "$work/a.png"
"$prayshade" --processes 2 $grown -F 1 -O "$work/a.png" "$work/long.ray" >"$work/said" 2>&1 &
host=$!
waits 200 grep -q 'Finished line' "$work/said"
kill -TERM $host
end
if [ -e "$work/a.png.partial" ]; then
  check "an interrupted picture goes on with -c" goes_on
  check "to the picture of an undisturbed run" cmp "$work/whole.png" "$work/a.png"
  check "and what was kept is gone" test ! -e "$work/a.png.partial"
else
  skip "an interrupted picture goes on with -c" "status $status: it was not interrupted between its rows"
fi

start
kill -TERM $host
end
check "SIGTERM ends the run with status 143" is 143
check "nothing is left after it" nothing_is_left
start
kill -9 $host
end
check "a run that is killed is status 137" is 137
check "nothing is left even then" nothing_is_left
exit $((failures > 0))
