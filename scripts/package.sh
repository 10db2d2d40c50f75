#!/usr/bin/env bash
# Makes Debian packages for all machines of this architecture in build-package/, or in another folder: installs what is
# missing, builds, and runs CPack. `apt-get install ./build-package/gaspard_*.deb` then installs the program for all
# users. Further arguments are options of CMake.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
folder=$here/build-package
if [ "${1:-}" = --folder ] && [ $# -ge 2 ]; then folder=$2; shift 2; fi
for option in "$@"; do
  case $option in
    -D?*=*) ;;
    *) echo "usage: scripts/package.sh [--folder FOLDER] [-DOPTION=VALUE ...]" >&2; exit 2 ;;
  esac
done
"$here/scripts/install-packages.sh" build package
log=$(mktemp)
echo "Building in $folder (the first time takes a few minutes) ..."
{ cmake -S "$here" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGASPARD_NATIVE=OFF -DGASPARD_TESTS=OFF \
    -DCMAKE_INSTALL_PREFIX=/usr -DGASPARD_UNITY=ON "$@" \
  && cmake --build "$folder" && cd "$folder" && rm -f -- *.deb && cpack; } >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
rm -f "$log"
ls "$folder"/*.deb
