# Configuring and building, quietly. Sourced by the scripts beside it.
# shellcheck shell=bash

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")

say() { echo "$*" >&2; }

# As many compilers as there are cores, but no more than one per GiB of memory: one can take that much.
jobs() {
  local cores memory_GiB
  cores=$(nproc)
  memory_GiB=$(awk '/^MemTotal:/ { print int($2 / 1048576) }' /proc/meminfo)
  echo $((memory_GiB < 1 ? 1 : memory_GiB < cores ? memory_GiB : cores))
}

# quietly LOG COMMAND…: the output goes to the log, and to the screen only when the command fails.
quietly() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" > "$log" 2>&1; then
    tail --lines 100 "$log" >&2
    say "Failed: $* (all of its output is in $log)"
    return 1
  fi
}

# configure PRESET [CMAKE ARGUMENT…]
configure() {
  local preset=$1
  shift
  (cd "$root" && quietly "$root/build/$preset-configure.log" cmake --preset "$preset" "$@")
}

# build PRESET [TARGET…]: on a terminal with ninja's one moving line, otherwise silent but for failures.
build() {
  local preset=$1 arguments=()
  shift
  arguments=("$root/build/$preset" --parallel "$(jobs)")
  if [[ $# -gt 0 ]]; then arguments+=(--target "$@"); fi
  if [[ -t 2 ]]; then
    NINJA_STATUS="Bringing Asperity ($preset) up to date: %f/%t " cmake --build "${arguments[@]}" >&2
  else
    say "Bringing Asperity ($preset) up to date; what is built, if anything, is in $root/build/$preset-build.log"
    quietly "$root/build/$preset-build.log" cmake --build "${arguments[@]}"
  fi
}

# The program as people run it.
# shellcheck disable=SC2034  # used by those who source this
asperity=$root/build/release/bin/asperity
build_program() {
  "$root/scripts/install" build
  configure release -DASPERITY_BUILD_TESTS=OFF -DASPERITY_BUILD_BENCH=OFF -DASPERITY_WARNINGS_AS_ERRORS=OFF
  build release asperity
}
