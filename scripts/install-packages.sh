#!/usr/bin/env bash
# Installs the Debian packages that are missing. Usage: install-packages.sh build|test|bench|package|fuzz ...
set -euo pipefail
build="build-essential cmake ninja-build pkg-config libglfw3-dev libimgui-dev libglm-dev libeigen3-dev
  libtinygltf-dev libegl-dev libgl-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libnetcdf-dev
  libopenmesh-dev libpugixml-dev libmuparser-dev libpng-dev libjpeg-dev zlib1g-dev libnanoflann-dev
  libstb-dev libgl1-mesa-dri libfontconfig-dev librsvg2-dev libcairo2-dev fonts-liberation"
# Not in every release: Mesa has dropped OSMesa after 25.0. Images are then drawn through EGL.
optional="libosmesa6"
test="libgtest-dev libassimp-dev libtinyxml2-dev xvfb xdotool x11-utils python3 python3-xlib
  desktop-file-utils fonts-droid-fallback poppler-utils"
bench="libbenchmark-dev python3 python3-dolfin python3-numpy python3-petsc4py python3-scipy"
package="dpkg-dev file"
# The same compiler in both releases: the default of Debian 12 has no std::source_location.
fuzz="clang-19 libclang-rt-19-dev llvm-19 python3"
wanted=
for group in "$@"; do
  case $group in
    build) wanted="$wanted $build" ;;
    test) wanted="$wanted $test" ;;
    bench) wanted="$wanted $bench" ;;
    package) wanted="$wanted $package" ;;
    fuzz) wanted="$wanted $fuzz" ;;
    *) echo "install-packages.sh: unknown group '$group' (build, test, bench, package, fuzz)" >&2; exit 2 ;;
  esac
done
installed() { dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed; }
missing=
for package in $wanted; do installed "$package" || missing="$missing $package"; done
[ -n "$missing" ] || exit 0
command -v apt-get >/dev/null || { echo "This script needs apt-get. Please install:$missing" >&2; exit 1; }
sudo=
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Please install as root:$missing" >&2; exit 1; }
  sudo=sudo
fi
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get update -q >/dev/null
for package in $optional; do
  if ! installed "$package" && [ -n "$(apt-cache madison "$package" 2>/dev/null)" ]; then missing="$missing $package"; fi
done
echo "Installing:$missing"
# shellcheck disable=SC2086
$sudo apt-get install -y -q --no-install-recommends $missing >/dev/null
