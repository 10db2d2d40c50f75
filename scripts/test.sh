#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests. With --full also the long tests and the sanitizer builds.
# docs/building.md describes the tests' labels.
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

build() { # folder, options of cmake; builds $targets (empty: all)
  local folder=$1; shift
  echo "Building in $folder ..."
  cmake -S "$here" -B "$folder" -G Ninja -DGASPARD_UNITY=ON -DGASPARD_TESTS=ON -DGASPARD_WERROR=ON "$@" >/dev/null
  # shellcheck disable=SC2086
  cmake --build "$folder" ${targets:+--target $targets} -- -d keeprsp >"$folder/build.log" 2>&1 \
    || { tail -n 60 "$folder/build.log" >&2; exit 1; }
}
run_tests() { # folder, options of ctest
  local folder=$1; shift
  ctest --test-dir "$folder" --output-on-failure -j "$jobs" "$@"
}
sanitize() { # name of the sanitizer, targets
  targets="$2" build "$here/build-$1" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DGASPARD_SANITIZER="$1"
}

if [ -n "$full" ]; then
  # Excluded: measured times, which sanitizers falsify; graphics drivers, which are not instrumented and keep memory.
  slow='graphics|display|long|numbers|timing'
  echo "== ThreadSanitizer: tests of code that runs on several threads"
  sanitize thread 'thread_tests gui_tests'
  run_tests "$here/build-thread" -L threads -LE "$slow"
  echo "== AddressSanitizer and UndefinedBehaviorSanitizer: all tests but graphics and long computations"
  sanitize address 'core_tests thread_tests gui_tests'
  run_tests "$here/build-address" -LE "$slow"
  echo "== Release: all tests"
  targets='' build "$here/build-test" -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON
  run_tests "$here/build-test"
else
  targets='' build "$here/build-test" -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON
  run_tests "$here/build-test" -LE long
fi
