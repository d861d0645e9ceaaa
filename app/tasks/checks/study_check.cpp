// Takes a lock in the folder as a test, and states whether every user can read the study.

#include "app/tasks/checks/study_check.h"

#include <filesystem>

#include "app/words/phrase_of_error.h"
#include "app/words/shell_word.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

constexpr const char* kStudyCheckLock = "session-check";

SessionCheck readable_study_check(const std::filesystem::path& study) {
  return {.state = State::look,
          .text = phrase("SessionChecks",
                         "The study folder is on a local disk and writable. Every user of this "
                         "computer can read it."),
          .remedy = phrase("SessionChecks", "To keep other users out, run: %1")
                        .with("chmod o-rwx " + shell_word(study.string()))};
}

}  // namespace

SessionCheck study_check(const CheckInputs& inputs) {
  try {
    // What a session needs: a reliable lock in a writable folder.
    const StudyLock lock(inputs.study, kStudyCheckLock);
    if (is_readable_by_others(inputs.study)) return readable_study_check(inputs.study);
    return fine_check(phrase("SessionChecks", "The study folder is on a local disk and writable."));
  } catch (const ResultsError& error) {
    return {
        .state = State::stop,
        .text = phrase_of(error).as_sentence(),
        .remedy = phrase("SessionChecks", "Move the study to a writable folder on a local disk.")};
  }
}

}  // namespace asperity
