#!/usr/bin/env bash
# Draws the images of README and docs with the program, into docs/. Usage: scripts/pictures.sh [PROGRAM]
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
gaspard=${1:-$here/build/gaspard}
[ -x "$gaspard" ] || { echo "scripts/pictures.sh: $gaspard does not exist; scripts/run.sh builds it" >&2; exit 2; }
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT

draw() { # name, then arguments of `gaspard run`
  local name=$1; shift
  "$gaspard" run "$@" --quiet --formats obj --out "$drawn/$name"
  mv "$drawn/$name/view.png" "$here/docs/$name.png"
  echo "docs/$name.png"
}

"$gaspard" compare plane-bell --methods relaxation,auto --out "$drawn/compare" > "$drawn/table"
mv "$drawn/compare/comparison.png" "$here/docs/compare.png"
echo docs/compare.png
"$gaspard" reproduce mcrae-fig4 --out "$drawn/flow" > "$drawn/table"
convert "$drawn/flow/mcrae-fig4.png" -resize 1200x "$here/docs/flow.png"
echo docs/flow.png

# Of the scenarios that move, at one of their times.
live() { # name, time, then arguments of `gaspard run`
  local name=$1 time=$2 scenario=$3; shift 3
  "$gaspard" run "$scenario" --quiet --formats obj --set time.end="$time" --size 640x520 --set view.theme=light \
    --set view.histogram=false --set view.caption=false "$@" --out "$drawn/$name"
  convert "$drawn/$name/view.png" -strip +dither -colors 128 "PNG8:$here/docs/$name.png"
  echo "docs/$name.png"
}
live live-flow 10 flow-live
live live-merging 1 flow-merging
live live-burgers 0.5 burgers-1d
live live-front 0.8 front-2d
live live-ring 5 plane-moving-ring
live live-cross 1.2 sphere-rotating-cross
draw window plane-bell --whole-window --size 1400x900
draw side-by-side plane-ring --size 1400x640 --set view.layout=side-by-side --set view.color=equidistribution \
  --set view.theme=light --set domain.cells=40
draw layer-2d layer-2d --size 1200x560 --set view.layout=side-by-side --set view.lines=false --set view.theme=light
draw layer-2d-heights layer-2d --size 1200x520 --set view.layout=side-by-side --set view.elevation=1.4 \
  --set view.lines=false --set view.theme=light
draw spline-ball spline-ball --size 900x680 --set domain.cells=20 --set view.cut="x 0.05 and y 0.05 and z 0.05" \
  --set view.theme=light --set view.histogram=false
draw sphere-x16 sphere-x16 --size 1400x740 --set view.layout=front-and-rear --set view.color=none \
  --set view.theme=light
draw sphere-cross sphere-cross --size 1200x900 --set view.theme=light --set view.histogram=false \
  --set view.camera="centre 0.05 0.02 -0.04 height 2.25 right -0.9272 0.3746 0 up -0.09 -0.2226 0.9707"
draw sphere-map sphere-cross --size 1200x640 --set view.theme=light --set view.layout=projection --set view.projection_longitude=90

# An animation: the camera moves once around the Möbius strip while the nodes move from ξ to x. ImageMagick (Debian's
# package imagemagick) joins the frames.
strip=(spline-moebius --quiet --formats obj --set domain.cells=40)
"$gaspard" run "${strip[@]}" --no-render --out "$drawn/strip"
frame=100
python3 - <<'PYTHON' |
import math
frames = 20
for k in range(frames):
    t = min(1, max(0, (k / frames - 0.1) / 0.55))
    a, e = math.radians(360 * k / frames - 70), math.radians(32)
    right, view = (-math.sin(a), math.cos(a), 0), (math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e))
    up = [view[i - 2] * right[i - 1] - view[i - 1] * right[i - 2] for i in range(3)]
    print(t * t * (3 - 2 * t), "right %.4f %.4f %.4f" % right, "up %.4f %.4f %.4f" % tuple(up))
PYTHON
  while read -r blend camera; do
    "$gaspard" run "${strip[@]}" --start "$drawn/strip/state.bin" --size 540x330 --set view.theme=light \
      --set view.histogram=false --set view.blend="$blend" --set view.camera="$camera" --out "$drawn/strip"
    mv "$drawn/strip/view.png" "$drawn/frame$((frame++)).png"
  done
convert -delay 16 -loop 0 "$drawn"/frame*.png -colors 48 +dither -layers optimize "$here/docs/spline-moebius.gif"
echo docs/spline-moebius.gif

# A film of time steps; the ring goes once round the periodic square.
"$gaspard" record plane-moving-ring --quiet --overwrite --set domain.cells=28 --set time.end=9.6 --set time.step=0.4 \
  --set view.legend=false --set view.axes=false --set view.caption=false --size 240x240 --rate 10 --formats gif --out "$drawn/ring"
mv "$drawn/ring/film.gif" "$here/docs/moving-ring.gif"
echo docs/moving-ring.gif
