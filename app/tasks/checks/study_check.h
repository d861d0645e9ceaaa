// Checks the folder of a study: writable, on a local disk, and who can read it.

#pragma once

#include "app/tasks/checks/session_check.h"

namespace asperity {

SessionCheck study_check(const CheckInputs& inputs);

}  // namespace asperity
