# Making a study and running it with virtual participants. Sourced by the scripts beside it.
# shellcheck shell=bash

readonly kParticipants=20
readonly kSeed=1

# begin_making STUDY sets $making, a folder to make the study in; end_making STUDY puts it in its place. What
# is interrupted in between leaves no half study behind.
begin_making() {
  local parent
  echo "Making the study $1" >&2
  parent=$(dirname "$1")
  mkdir -p "$parent"
  making_in=$(mktemp --directory "$parent/.making-study.XXXXXX")
  trap 'rm --recursive --force "$making_in"' EXIT
  making=$making_in/$(basename "$1")
}

end_making() {
  mv --no-target-directory --no-clobber "$making" "$1"
  rm --recursive --force "$making_in"
}

# simulate_and_analyze ASPERITY STUDY PROTOCOL…: what is complete already is left as it is.
simulate_and_analyze() {
  local asperity=$1 study=$2 files=() protocol
  shift 2
  for protocol in "$@"; do
    files+=("$study/protocols/$protocol.json")
    if [[ ! -e ${files[-1]} ]]; then
      echo "$study is there, but it is not the study that this makes: it has no protocols/$protocol.json." \
        "Name another folder, or move this one away. Nothing in it was changed." >&2
      exit 1
    fi
  done
  echo "Completing $kParticipants virtual participants, ${#files[@]} sessions each" >&2
  # Without the line for every stored attempt. At Ctrl-C asperity finishes the trials under way and says so.
  "$asperity" simulate "${files[@]}" --study "$study" --participants "$kParticipants" --seed "$kSeed" \
    --jobs "$(nproc)" --resume 2>&1 | (trap '' INT; awk '!/^(done|stored) / { print; fflush() }') >&2
  echo >&2
  "$asperity" analyze "$study"
  echo >&2
  echo "The study is in $study; its tables come out with: scripts/run export $study --out TABLES" >&2
}
