#!/usr/bin/env bash
# Installs what is missing, builds, and opens the window. Arguments are passed to gaspard.
# Without a display it solves the default scenario and prints where the image is.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
"$here/scripts/install-packages.sh" build
log=$(mktemp); trap 'rm -f "$log"' EXIT
echo "Building in $here/build (the first time takes a few minutes) ..."
{ cmake -S "$here" -B "$here/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=ON -DGASPARD_UNITY=ON -DGASPARD_TESTS=OFF \
  && cmake --build "$here/build"; } >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
rm -f "$log"; trap - EXIT
if [ $# -eq 0 ] && [ -z "${DISPLAY:-}" ] && [ -z "${WAYLAND_DISPLAY:-}" ]; then
  echo "No display: solving the scenario plane-ring without a window."
  out="$PWD/gaspard-out/plane-ring"
  "$here/build/gaspard" run plane-ring --out "$out"
  echo "The image is $out/view.png"
  exit 0
fi
exec "$here/build/gaspard" "$@"
