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

build() { # folder, cmake options; targets come from $targets (empty: all)
  local folder=$1; shift
  cmake -S "$here" -B "$folder" -G Ninja -DGASPARD_TESTS=ON "$@" >/dev/null
  # shellcheck disable=SC2086
  cmake --build "$folder" ${targets:+--target $targets} -- -d keeprsp >"$folder/build.log" 2>&1 \
    || { tail -n 60 "$folder/build.log" >&2; exit 1; }
}
run_tests() { # folder, options of ctest
  local folder=$1; shift
  ctest --test-dir "$folder" --output-on-failure -j "$jobs" "$@"
}

if [ -n "$full" ]; then
  # A sanitizer slows everything down: tests of time, known by their names, would say nothing. Graphics drivers are
  # not instrumented, and Mesa keeps memory that it never frees.
  slow='graphics|display|long|numbers' of_time='IsQuick|TakesNoTime'
  echo "== ThreadSanitizer: whatever more than one thread runs through"
  targets='thread_tests gui_tests' build "$here/build-thread" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DGASPARD_SANITIZER=thread
  run_tests "$here/build-thread" -L threads -LE "$slow" -E "$of_time"
  echo "== AddressSanitizer and UndefinedBehaviorSanitizer: all but pictures and long sums"
  targets='core_tests thread_tests gui_tests' build "$here/build-address" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DGASPARD_SANITIZER=address
  run_tests "$here/build-address" -LE "$slow" -E "$of_time|NOT_BUILT"
  echo "== Release"
  targets='' build "$here/build-test" -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON
  run_tests "$here/build-test"
else
  targets='' build "$here/build-test" -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON
  run_tests "$here/build-test" -LE long
fi
