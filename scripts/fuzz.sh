#!/usr/bin/env bash
# Feeds a reader with random bytes: scripts/fuzz.sh TARGET SECONDS. `all` runs every target, SECONDS each; without
# arguments the targets are listed. Stops at the first finding, which is kept in build-fuzz/findings.
# docs/building.md says how to add a target and what to do with a finding.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
targets=$(cd "$here/fuzz/seeds" && ls)
if [ $# -eq 0 ]; then
  echo "$targets"
  exit 0
fi
if [ $# -ne 2 ] || ! [[ $2 =~ ^[0-9]+$ ]] || { [ "$1" != all ] && ! grep -qxF -- "$1" <<<"$targets"; }; then
  echo "usage: scripts/fuzz.sh TARGET|all SECONDS; targets:" $targets >&2
  exit 2
fi
[ "$1" = all ] || targets=$1
"$here/scripts/install-packages.sh" build fuzz
folder=$here/build-fuzz
mkdir -p "$folder/findings"
echo "Building in $folder (the first time takes a few minutes) ..."
{ cmake -S "$here" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_CXX_COMPILER=clang++-19 -DGASPARD_SANITIZER=fuzzer -DGASPARD_PROGRAM=OFF -DGASPARD_TESTS=OFF \
  && cmake --build "$folder" --target gaspard_fuzz; } >"$folder/build.log" 2>&1 \
  || { tail -n 60 "$folder/build.log" >&2; exit 1; }

# A finding ends with code 77; 1 GiB and 10 s are what an input of up to 64 KiB may cost.
limits=(-rss_limit_mb=1024 -timeout=10 -max_len=65536)
export ASAN_OPTIONS=quarantine_size_mb=32:${ASAN_OPTIONS:-}
for target in $targets; do
  export GASPARD_FUZZ_TARGET=$target
  corpus=$folder/corpus/$target
  known=("$here/fuzz/seeds/$target")
  [ ! -d "$here/fuzz/regressions/$target" ] || known+=("$here/fuzz/regressions/$target")
  mkdir -p "$corpus"
  echo "== $target for $2 s"
  "$folder/fuzz/gaspard_fuzz" "${limits[@]}" -max_total_time="$2" -print_final_stats=1 -error_exitcode=77 \
    -artifact_prefix="$folder/findings/$target-" "$corpus" "${known[@]}" >"$folder/$target.log" 2>&1 \
    || { grep -v '^#' "$folder/$target.log" | tail -n 60 >&2; echo "scripts/fuzz.sh: $target has a finding" >&2; exit 1; }
  grep -E 'number_of_executed_units|peak_rss_mb' "$folder/$target.log"
  "$folder/fuzz/gaspard_fuzz" "${limits[@]}" -runs=0 -print_coverage=1 "$corpus" "${known[@]}" 2>&1 \
    | python3 "$here/fuzz/coverage.py"
done
