// Compares the number of screens with the two windows of a session.

#include "app/tasks/checks/screens_check.h"

#include <string>

namespace asperity {
namespace {

using State = SessionCheck::State;

}  // namespace

SessionCheck screens_check(const CheckInputs& inputs) {
  if (inputs.mode == SessionMode::simulate) {
    return fine_check(
        phrase("SessionChecks", "Not needed: no participant looks at the participant's window."));
  }
  if (inputs.screens >= 2) {
    return fine_check(phrase("SessionChecks", "%1 screens: one for each window.")
                          .with(std::to_string(inputs.screens)));
  }
  return {.state = State::look,
          .text = phrase(
              "SessionChecks",
              "One screen: the two windows are side by side, and the participant can see both."),
          .remedy = phrase("SessionChecks", "Connect a second screen for the participant.")};
}

}  // namespace asperity
