#!/usr/bin/env bash
# Installs Debian's packages that are missing. Usage: install-packages.sh build|test|bench|package ...
set -euo pipefail
build="build-essential cmake ninja-build pkg-config libglfw3-dev libimgui-dev libglm-dev libeigen3-dev
  libtinygltf-dev libosmesa6-dev libegl-dev libgl-dev libcli11-dev libtomlplusplus-dev
  nlohmann-json3-dev libnetcdf-dev libopenmesh-dev libstb-dev libgl1-mesa-dri"
test="libgtest-dev libassimp-dev libtinyxml2-dev libpng-dev xvfb xdotool x11-utils python3 desktop-file-utils"
bench="libbenchmark-dev python3 python3-dolfin python3-numpy python3-petsc4py python3-scipy"
package="dpkg-dev file"
wanted=
for group in "$@"; do
  case $group in
    build) wanted="$wanted $build" ;;
    test) wanted="$wanted $test" ;;
    bench) wanted="$wanted $bench" ;;
    package) wanted="$wanted $package" ;;
    *) echo "install-packages.sh: unknown group '$group' (build, test, bench, package)" >&2; exit 2 ;;
  esac
done
missing=
for package in $wanted; do
  dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
command -v apt-get >/dev/null || { echo "Gaspard's scripts install packages with apt-get, which this system lacks; needed:$missing" >&2; exit 1; }
sudo=
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Please install as root:$missing" >&2; exit 1; }
  sudo=sudo
fi
echo "Installing:$missing"
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get update -q >/dev/null
# shellcheck disable=SC2086
$sudo apt-get install -y -q --no-install-recommends $missing >/dev/null
