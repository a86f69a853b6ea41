# For tests/*/*_test.sh, by `.`: the three words that run_tests.sh counts, a folder that goes away, the shared scenes.
#   check SENTENCE COMMAND...   ok where the command succeeds, else not ok and what it said
#   skip SENTENCE REASON
# $work is an empty folder; $shared the folder of scenes and references that a user may bring (RAYSHADE_SHARED).
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 2
BUILD=${BUILD:-$PWD/build}
shared=${RAYSHADE_SHARED:-../shared}
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
failures=0

check() {
  local sentence=$1 said
  shift
  if said=$("$@" 2>&1); then
    echo "ok - $sentence"
  else
    echo "not ok - $sentence"
    [ -z "$said" ] || echo "$said" | tail -n 20 | sed 's/^/    /'
    failures=$((failures + 1))
  fi
}
skip() { echo "skip - $1: $2"; }
