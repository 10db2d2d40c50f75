#!/usr/bin/env bash
# Draws the pictures that README and docs show, with the program itself, into docs/.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
gaspard=${1:-$here/build/gaspard}
[ -x "$gaspard" ] || { echo "scripts/pictures.sh: there is no program $gaspard; scripts/run.sh builds it" >&2; exit 2; }
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT

picture() { # name, then what `gaspard run` is given
  local name=$1; shift
  "$gaspard" run "$@" --quiet --formats obj --out "$drawn/$name"
  mv "$drawn/$name/view.png" "$here/docs/$name.png"
  echo "docs/$name.png"
}

"$gaspard" compare plane-bell --methods relaxation,auto --out "$drawn/compare" > "$drawn/table"
mv "$drawn/compare/comparison.png" "$here/docs/compare.png"
echo docs/compare.png
picture window plane-bell --whole-window --size 1400x900
picture side-by-side plane-ring --size 1400x640 --set view.layout=side-by-side --set view.color=equidistribution \
  --set view.theme=light --set domain.cells=40
picture sphere-x16 sphere-x16 --size 1400x740 --set view.layout=front-and-rear --set view.color=none \
  --set view.theme=light
picture sphere-cross sphere-cross --size 1200x900 --set view.theme=light --set view.histogram=false \
  --set view.camera="centre 0.05 0.02 -0.04 height 2.25 right -0.9272 0.3746 0 up -0.09 -0.2226 0.9707"
picture spline-moebius spline-moebius --size 1200x700 --set view.theme=light --set view.histogram=false --set domain.cells=48
picture sphere-map sphere-cross --size 1200x640 --set view.theme=light --set view.layout=map --set view.map_longitude=90
