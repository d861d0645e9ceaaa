# Making a study and running it with virtual participants. Sourced by the other scripts of this folder.
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

# number_at PLACE STUDY: a number in the header of the database of a study (https://www.sqlite.org/fileformat.html).
readonly kSchemaPlace=60 kApplicationPlace=68
number_at() {
  od --address-radix=n --endian=big --format=u4 --skip-bytes="$1" --read-bytes=4 "$2/study.sqlite" | tr --delete ' '
}

# choose_study ASPERITY STUDY sets $study to STUDY, or, if that has another schema than the studies of this program, to
# the first of STUDY-2, STUDY-3, … that does not exist or has this schema.
choose_study() {
  local asperity=$1 empty n=1
  study=${2%/}
  if [[ ! -e $study/study.sqlite ]]; then return; fi
  empty=$(mktemp --directory)
  "$asperity" new "$empty/study" > /dev/null
  while [[ -e $study/study.sqlite && $(number_at $kApplicationPlace "$study") == "$(number_at $kApplicationPlace "$empty/study")" &&
    $(number_at $kSchemaPlace "$study") != "$(number_at $kSchemaPlace "$empty/study")" ]]; do
    n=$((n + 1))
    echo "The study $study has schema $(number_at $kSchemaPlace "$study"), and this program uses" \
      "schema $(number_at $kSchemaPlace "$empty/study"). It is kept; the study ${2%/}-$n is used instead." >&2
    study=${2%/}-$n
  done
  rm --recursive "$empty"
}

# simulate_participants ASPERITY STUDY SCRIPT PROTOCOL…: what is complete already is left as it is. SCRIPT is the command that
# resumes the simulation after Ctrl-C.
simulate_participants() {
  local asperity=$1 study=$2 script=$3 files=() protocol interrupted=
  shift 3
  for protocol in "$@"; do
    files+=("$study/protocols/$protocol.json")
    if [[ ! -e ${files[-1]} ]]; then
      echo "$study is there, but it is not the study that this makes: it has no protocols/$protocol.json." \
        "Name another folder, or move this one away. Nothing in it was changed." >&2
      exit 1
    fi
  done
  echo "$kParticipants virtual participants, ${#files[@]} sessions each: those that are not stored yet are simulated" >&2
  # Without the line for every stored attempt, and on a terminal with one moving line of progress. At Ctrl-C asperity
  # finishes the trials under way, and writes that it does.
  trap 'interrupted=1' INT
  local status=0
  "$asperity" simulate "${files[@]}" --study "$study" --participants "$kParticipants" --seed "$kSeed" \
    --jobs "$(nproc)" --resume 2>&1 | (trap '' INT; awk -v is_terminal="$(if [[ -t 2 ]]; then echo 1; fi)" '
      /^(done|stored) |^asperity: each stored attempt / { next }
      { if (moving) printf "\r" }
      { moving = is_terminal && /^simulating: /; printf moving ? "%s" : "%s\n", $0; fflush() }
      END { if (moving) print "" }') >&2 || status=$?
  if [[ $status -ne 0 ]]; then
    if [[ $interrupted ]]; then echo "To resume the simulation, call $script again." >&2; fi
    exit "$status"
  fi
  trap - INT
  echo >&2
}
