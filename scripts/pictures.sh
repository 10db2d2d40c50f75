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

picture window plane-bell --whole-window --size 1400x900
picture side-by-side plane-ring --size 1400x640 --set view.layout=side-by-side --set view.color=equidistribution \
  --set view.theme=light --set domain.cells=40
