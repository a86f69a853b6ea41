#!/bin/sh
# What the project needs from the system, and how to get it: dependencies.sh [build] [test] [charts] [fuzz] [count]
# Each line of a group is a package and the one cheap look that shows whether it is there (a command, or a header with
# its full path). Nothing missing: silence and status 0, in a few milliseconds, so that every `make` can ask.
# Something missing: apt-get installs it, as root or through sudo; elsewhere the list is printed, and the status is 1.
set -u

needs() {
  case $1 in
    build) echo 'g++ g++
cpp cpp
flex flex
bison bison
libpng-dev /usr/include/png.h
pvm pvmd
pvm-dev /usr/include/pvm3.h' ;;
    test) echo 'libgtest-dev /usr/include/gtest/gtest.h' ;;
    fuzz) echo 'clang clang++' ;;
    count) echo 'valgrind valgrind' ;;
    charts) echo 'gnuplot-nox gnuplot' ;;
    *) echo "dependencies.sh: no group named $1" >&2; exit 2 ;;
  esac
}

is_there() {
  case $1 in
    /*) [ -e "$1" ] || [ -e "/usr/local${1#/usr}" ] ;;
    *) command -v "$1" >/dev/null 2>&1 ;;
  esac
}

missing=
for group in "${@:-build}"; do
  wanted=$(needs "$group") || exit 2
  while read -r package probe; do
    is_there "$probe" || missing="$missing $package"
  done <<END
$wanted
END
done
[ -n "$missing" ] || exit 0
missing=${missing# }

refuse() {
  {
    echo "Missing: $missing"
    echo "$1"
    echo "  Debian, Ubuntu:  apt-get install $missing"
    echo "  elsewhere:       a C++20 compiler, flex, bison, libpng, PVM 3.4 (library and pvmd), GoogleTest"
  } >&2
  exit 1
}

command -v apt-get >/dev/null 2>&1 || refuse "This system has no apt-get; please install by hand:"
as_root=
if [ "$(id -u)" != 0 ]; then
  command -v sudo >/dev/null 2>&1 || refuse "This needs root, and there is no sudo; please ask for:"
  as_root=sudo
fi

echo "Installing: $missing"
install_missing() {
  # shellcheck disable=SC2086  # words on purpose: one package each
  $as_root env DEBIAN_FRONTEND="${DEBIAN_FRONTEND:-noninteractive}" \
    apt-get install -y -qq --no-install-recommends $missing
}
{ $as_root apt-get update -qq && install_missing; } >&2 || refuse "apt-get could not install them; please see above, or install by hand:"
