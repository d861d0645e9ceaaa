// What could be answered, as it is stored beside every answer.

#pragma once

#include <string>

#include "protocols/plan/plan.h"

namespace asperity {

/// JSON of the values of a trial's options, in the order in which they are shown; "[]" where a number is
/// asked for.
std::string options_json_of(const Trial& trial);

}  // namespace asperity
