# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
# Sourced by ./run and ./test: installs missing Debian packages, configures and builds the release.

spinPackages=(
  cmake ninja-build g++ ccache pkg-config python3 git ca-certificates
  libeigen3-dev libtbb-dev libfmt-dev libxxhash-dev libblosc-dev libgtest-dev
  qt6-base-dev qt6-l10n-tools qt6-tools-dev qt6-tools-dev-tools
  libgdal-dev libassimp-dev libopencv-dev libopenvdb-dev libembree-dev libcli11-dev libepoxy-dev libgl-dev libegl-dev
  libgl1-mesa-dri libegl-mesa0 libegl1 libglx-mesa0 libxkbcommon-dev fonts-dejavu-core
)

spinSay() { printf '== %s\n' "$*"; }

# Installs what dpkg does not know as installed; silent when nothing is missing.
spinInstall() {
  local missing=() package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  local asRoot=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "These packages are missing and there is no sudo: ${missing[*]}" >&2; return 1; }
    asRoot=(sudo)
  fi
  spinSay "installing ${#missing[@]} Debian packages: ${missing[*]}"
  local log
  log=$(mktemp)
  # An old package list makes installs fail, so a second try refreshes it.
  if ! "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >"$log" 2>&1; then
    "${asRoot[@]}" apt-get update -q >>"$log" 2>&1
    "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >>"$log" 2>&1 ||
      { tail -n 20 "$log" >&2; echo "Installing packages failed; the whole log is in $log" >&2; return 1; }
  fi
  rm -f "$log"
}

# spinBuild TARGET...: configures once and builds; prints the time it took.
spinBuild() {
  local start=$SECONDS log=build/release/configure.log
  mkdir -p build/release
  if [ ! -f build/release/build.ninja ]; then
    spinSay "configuring the release build in build/release"
    cmake --preset release >"$log" 2>&1 || { tail -n 30 "$log" >&2; return 1; }
    grep -h '^-- CUDA backend' "$log" | sed 's/^-- /   /' || true
  fi
  spinSay "building${*:+ $*}"
  cmake --build build/release ${*:+--target "$@"} -- ${SPIN_NINJA_FLAGS:---quiet} || return 1
  spinSay "built in $((SECONDS - start)) s"
}
