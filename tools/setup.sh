#!/usr/bin/env bash
# What ./run and ./test share: installs what is missing (Debian 12, root) and builds. Source it, then call
#   install_packages [test]   and   build PRESET TESTS [target ...]
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# To build and run: compiler, image formats, window, small libraries, Mesa's drivers, the example scan, and what encodes films.
PACKAGES=(
  g++ cmake ninja-build ccache pkg-config
  libinsighttoolkit5-dev libgdcm-dev libfftw3-dev libexpat1-dev libeigen3-dev zlib1g-dev
  qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-qpa-plugins qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
  libepoxy-dev libegl-dev libgl1-mesa-dri libegl-mesa0 libegl1 libgl1 libglx-mesa0
  libglm-dev libfmt-dev nlohmann-json3-dev libcli11-dev libzstd-dev libblosc-dev libtiff-dev libpng-dev
  libseccomp-dev
  libcairo2-dev fonts-dejavu-core
  libvtk9-dev libdcmtk-dev
  mricron-data
  ffmpeg curl
)
# To test: a display without a screen, a hand on the mouse, and the checkers.
TEST_PACKAGES=(libgtest-dev librapidcheck-dev libxcb1-dev python3 python3-pydicom python3-nibabel python3-zarr python3-tifffile teem-apps git xvfb xdotool glslang-tools spirv-tools clang-format-14 clang-tidy-14 clang-14 libclang-rt-14-dev dpkg-dev file
  desktop-file-utils appstream dbus-daemon)

say() { printf '== %s\n' "$*"; }

# is_time_for SECONDS: whether so much is left before TESTS_UNTIL (seconds of date +%s), if that is set.
is_time_for() { [ -z "${TESTS_UNTIL:-}" ] || [ $(($(date +%s) + $1)) -lt "$TESTS_UNTIL" ]; }

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

# build PRESET TESTS [target ...]: builds what changed. Configures when that has not been done, or was done without the
# tests (whose packages ./run does not install) and TESTS is ON.
build() {
  local preset=$1 tests=$2
  shift 2
  BUILD=$ROOT/build/$preset
  say "building (preset $preset) into $BUILD"
  (
    cd "$ROOT"
    mkdir -p "$ROOT/build"
    if [ ! -f "$BUILD/build.ninja" ] ||
      { [ "$tests" = ON ] && ! grep -q '^VOLUME_STUDIO_BUILD_TESTS:BOOL=ON' "$BUILD/CMakeCache.txt"; }; then
      cmake --preset "$preset" -DVOLUME_STUDIO_BUILD_TESTS="$tests" >"$BUILD.log" 2>&1 ||
        { cat "$BUILD.log" >&2; exit 1; }
    fi
    cmake --build --preset "$preset" ${1:+--target "$@"}
  )
}
