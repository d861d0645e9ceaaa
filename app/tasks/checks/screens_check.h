// Checks whether there is a screen for the participant.

#pragma once

#include "app/tasks/checks/session_check.h"

namespace asperity {

SessionCheck screens_check(const CheckInputs& inputs);

}  // namespace asperity
