# Configuring and building, quietly. Sourced by the other scripts of this folder, which end with the first failure.
# shellcheck shell=bash
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")

say() { echo "$*" >&2; }

# As many compilers as there are cores, but no more than two for 3 GiB of memory: one takes up to 1.4 GiB.
jobs() {
  local cores for_memory
  cores=$(nproc)
  for_memory=$(awk '/^MemTotal:/ { print int($2 / 1048576 / 1.5) }' /proc/meminfo)
  echo $((for_memory < 1 ? 1 : for_memory < cores ? for_memory : cores))
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
  if [[ ! -e $root/build/$preset/build.ninja ]]; then say "Configuring the build, up to a minute"; fi
  (cd "$root" && quietly "$root/build/$preset-configure.log" cmake --preset "$preset" "$@")
}

# report_progress NAME LOG: copies ninja's output from standard input to the log. Of a build of more than a few steps it
# writes to the screen how many there are, each tenth of them, and, as the last steps take longest, the first step that ends two
# minutes after the line before.
report_progress() {
  local name=$1 log=$2 line finished steps shown=-1 last=0
  local -r few=10  # what is linked and checked again without a change, and some files
  while IFS= read -r line; do
    printf '%s\n' "$line" >&3
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      finished=${BASH_REMATCH[1]} steps=${BASH_REMATCH[2]}
      if ((steps <= few || (finished * 10 / steps <= shown && SECONDS < last + 120))); then continue; fi
      if ((shown < 0)); then
        say "Building $name: $steps steps, the last of which take longest."
        say "The compiler's output is in ${log#"$root/"}"
      fi
      last=$SECONDS
      shown=$((finished * 10 / steps))
      if ((shown > 0)); then
        say "$(printf 'Building %s: %d of %d steps after %d:%02d' "$name" "$finished" "$steps" $((SECONDS / 60)) $((SECONDS % 60)))"
      fi
    fi
  done 3> "$log"
}

# build PRESET [TARGET…]: on a terminal with ninja's one moving line, which is removed at the end, otherwise with a line each tenth
# of a long build.
build() {
  local preset=$1 arguments=() log="$root/build/$1-build.log"
  shift
  arguments=("$root/build/$preset" --parallel "$(jobs)")
  if [[ $# -gt 0 ]]; then arguments+=(--target "$@"); fi
  if [[ -t 2 ]]; then
    NINJA_STATUS="Building Asperity ($preset): %f of %t steps after %e s " cmake --build "${arguments[@]}" >&2 || return
    if [[ ${TERM-dumb} != dumb ]]; then printf '\033[A\033[2K' >&2; fi
  elif ! (SECONDS=0; NINJA_STATUS="[%f/%t] " cmake --build "${arguments[@]}" 2>&1 | report_progress "Asperity ($preset)" "$log"); then
    tail --lines 100 "$log" >&2
    say "Failed: cmake --build ${arguments[*]} (all of its output is in $log)"
    return 1
  fi
}

# build_with_tests TARGET…: in the same folder, configured with the tests.
build_with_tests() {
  "$root/scripts/install" build test
  configure release -DASPERITY_BUILD_TESTS=ON
  build release "$@"
}

# build_program [TARGET…]: the program, which people run and the tests test, or another target: one build folder for all. The tests
# are configured by scripts/test, and stay configured: what is built is never removed by the other script.
# shellcheck disable=SC2034  # used by those who source this
asperity=$root/build/release/bin/asperity
build_program() {
  "$root/scripts/install" build
  configure release
  build release "${@:-asperity}"
}
