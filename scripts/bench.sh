#!/usr/bin/env bash
# Measures Gaspard and its peer in one run on this machine and prints the tables of docs/performance.md, then the parts
# of an iteration with the machine's limits. Arguments go to bench/compare.py (--repeat R, --quick).
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
"$here/scripts/install-packages.sh" build bench
log=$(mktemp)
echo "Building in $here/build-bench ..."
{ cmake -S "$here" -B "$here/build-bench" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON -DGASPARD_TESTS=OFF \
    -DGASPARD_BENCH=ON && cmake --build "$here/build-bench"; } >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
rm -f "$log"
python3 "$here/bench/compare.py" "$here/build-bench/gaspard" "$@"
echo
python3 "$here/bench/parts.py" "$here/build-bench/bench"
"$here/build-bench/bench/bench_sphere" --benchmark_min_time=0.2 --benchmark_repetitions=3 \
  --benchmark_report_aggregates_only=true --benchmark_display_aggregates_only=true 2>/dev/null | grep -v -E '_stddev|_cv|_mean'
echo
"$here/build-bench/bench/bench_formula"
echo
python3 "$here/bench/splines.py" "$here/build-bench/bench/bench_splines"
echo
python3 "$here/bench/layers.py" "$here/build-bench/bench/bench_layers"
echo
python3 "$here/bench/transport.py" "$here/build-bench/bench/bench_transport"
echo
"$here/build-bench/bench/bench_flow"
echo
"$here/build-bench/bench/bench_flow_monitors"
echo
"$here/build-bench/bench/measure_orders"
