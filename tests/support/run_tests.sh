#!/bin/bash
# Runs every test and counts: run_tests.sh BUILD [GTEST_FILTER]
# First BUILD/unit_tests, then each tests/*/*_test.sh (only where no filter is given). A shell test prints a line
# `ok - SENTENCE`, `not ok - SENTENCE` or `skip - SENTENCE: REASON` for each thing it tests; one that ends with another
# status than 0 without saying `not ok` counts as one failure. It finds the programs under $BUILD (a full path).
# The last line is `N passed, N failed, N skipped`; the status is 0 where nothing failed.
set -u
cd "$(dirname "$0")/../.." || exit 2
BUILD=$(cd "$1" && pwd) || exit 2
export BUILD
filter=${2:-*}
log=$BUILD/tests.log
: >"$log"
passed=0 failed=0 skipped=0
count() { grep -cE "$1" "$2"; }

"$BUILD/unit_tests" --gtest_filter="$filter" 2>&1 | tee "$log"
status=${PIPESTATUS[0]}
passed=$(count '^\[       OK \] .*ms\)$' "$log")
skipped=$(count '^\[  SKIPPED \] .*ms\)$' "$log")
failed=$(count '^\[  FAILED  \] .*ms\)$' "$log")
if [ "$status" != 0 ] && [ "$failed" = 0 ]; then
  echo "unit_tests ended early, with status $status"
  failed=1
fi

if [ "$filter" = '*' ]; then
  for script in tests/*/*_test.sh; do
    [ -e "$script" ] || continue
    echo "-- $script"
    bash "$script" >"$log" 2>&1
    status=$?
    cat "$log"
    bad=$(count '^not ok - ' "$log")
    if [ "$status" != 0 ] && [ "$bad" = 0 ]; then
      echo "not ok - $script ended with status $status"
      bad=1
    fi
    passed=$((passed + $(count '^ok - ' "$log")))
    skipped=$((skipped + $(count '^skip - ' "$log")))
    failed=$((failed + bad))
  done
fi
rm -f "$log"

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ] && [ "$passed" != 0 ]
