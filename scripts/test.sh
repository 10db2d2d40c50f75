#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests. With --full also the long tests and the sanitizer builds.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
full=
case "${1:-}" in
  --full) full=yes ;;
  '') ;;
  *) echo "usage: scripts/test.sh [--full]" >&2; exit 2 ;;
esac
"$here/scripts/install-packages.sh" build test
jobs=$(nproc)

build_and_test() { # folder, label expression of tests to leave out (empty: none), cmake options ...
  local folder=$1 leave_out=$2 sanitizer=; shift 2
  case "$*" in *GASPARD_SANITIZER*) sanitizer=yes ;; esac
  cmake -S "$here" -B "$folder" -G Ninja -DGASPARD_TESTS=ON "$@" >/dev/null
  cmake --build "$folder" -- -d keeprsp >"$folder/build.log" 2>&1 || { tail -n 60 "$folder/build.log" >&2; exit 1; }
  # A sanitizer slows everything down: tests of time, known by their names, would say nothing.
  ctest --test-dir "$folder" --output-on-failure -j "$jobs" \
    ${leave_out:+-LE "$leave_out" ${sanitizer:+-E 'IsQuick|TakesNoTime'}}
}

if [ -n "$full" ]; then
  echo "== ThreadSanitizer (the core and its threads; graphics drivers are not instrumented)"
  build_and_test "$here/build-thread" 'graphics|display|long|numbers' -DCMAKE_BUILD_TYPE=RelWithDebInfo -DGASPARD_SANITIZER=thread
  echo "== AddressSanitizer and UndefinedBehaviorSanitizer (likewise: Mesa keeps memory that it never frees)"
  build_and_test "$here/build-address" 'graphics|display|long|numbers' -DCMAKE_BUILD_TYPE=RelWithDebInfo -DGASPARD_SANITIZER=address
  echo "== Release"
  build_and_test "$here/build-test" '' -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON
else
  build_and_test "$here/build-test" long -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON
fi
