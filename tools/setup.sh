#!/usr/bin/env bash
# What ./run and ./test share: installs what is missing (Debian 12, root) and builds. Source it, then call
#   install_packages [test]   and   build PRESET [target ...]
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# To build and run: compiler, image formats, window, small libraries, Mesa's drivers, and the example scan.
PACKAGES=(
  g++ cmake ninja-build ccache pkg-config
  libinsighttoolkit5-dev libgdcm-dev libfftw3-dev libexpat1-dev libeigen3-dev zlib1g-dev
  qt6-base-dev libqt6opengl6-dev libqt6svg6-dev qt6-qpa-plugins
  libepoxy-dev libegl-dev libgl1-mesa-dri libegl-mesa0 libegl1 libgl1 libglx-mesa0
  libglm-dev libfmt-dev nlohmann-json3-dev libcli11-dev libzstd-dev libpng-dev
  mricron-data
)
# To test: a display without a screen, a hand on the mouse, and the checkers.
TEST_PACKAGES=(libgtest-dev python3 xvfb xdotool glslang-tools clang-format-14)

say() { printf '== %s\n' "$*"; }

install_packages() {
  local wanted=("${PACKAGES[@]}") missing=()
  [ "${1:-}" = test ] && wanted+=("${TEST_PACKAGES[@]}")
  for package in "${wanted[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "all Debian packages are there"
    return
  fi
  if [ "$(id -u)" != 0 ]; then
    echo "these Debian packages are missing: ${missing[*]}; run as root, or install them with apt-get" >&2
    exit 1
  fi
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build PRESET [target ...]: configures once, then builds what changed.
build() {
  local preset=$1
  shift
  BUILD=$ROOT/build/$preset
  say "building (preset $preset) into $BUILD"
  (
    cd "$ROOT"
    [ -f "$BUILD/build.ninja" ] || cmake --preset "$preset" >"/tmp/volume-studio-configure.$$" ||
      { cat "/tmp/volume-studio-configure.$$" >&2; exit 1; }
    rm -f "/tmp/volume-studio-configure.$$"
    cmake --build --preset "$preset" ${1:+--target "$@"}
  )
}
