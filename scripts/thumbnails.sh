#!/usr/bin/env bash
# Draws the small pictures of the scenarios in the window's list with the program, into assets/thumbnails/.
# ImageMagick (Debian's package imagemagick) makes them smaller. Usage: scripts/thumbnails.sh [PROGRAM] [SCENARIO ...]
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
gaspard=${1:-$here/build/gaspard}
shift || true
[ -x "$gaspard" ] || { echo "scripts/thumbnails.sh: $gaspard does not exist; scripts/run.sh builds it" >&2; exit 2; }
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
into=$here/assets/thumbnails
mkdir -p "$into"

bare=(--set view.layout=single --set view.theme=dark --set view.background=theme --set view.legend=false
      --set view.caption=false --set view.note=false --set view.axes=false)
names=("$@")
[ ${#names[@]} -gt 0 ] || mapfile -t names < <("$gaspard" list scenarios | awk 'NF && /^  /{print $1}')
for name in "${names[@]}"; do
  own=()
  case $name in
    layer-1d*|burgers*) own=(--set view.text_size=0.6 --set view.lines=false) ;;
    flow-merging) own=(--set time.end=1) ;;
    front-2d) own=(--set time.end=0.8) ;;
    plane-moving-ring) own=(--set time.end=2) ;;
  esac
  # At twice the size, so that lines are thinner than a pixel.
  "$gaspard" run "$name" --quiet --formats obj --size 256x192 "${bare[@]}" "${own[@]}" --out "$drawn/$name" \
    || [ -f "$drawn/$name/view.png" ] # a status other than converged
  convert "$drawn/$name/view.png" -filter box -resize 128x96 -strip +dither -colors 200 "PNG8:$into/$name.png"
  echo "assets/thumbnails/$name.png"
done
