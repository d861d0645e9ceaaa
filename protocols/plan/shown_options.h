// Declares the JSON of the shown options, which is stored with every response.

#pragma once

#include <string>

#include "protocols/plan/plan.h"

namespace asperity {

/// The JSON of the values of a trial's options, in the order in which they are shown; "[]" if the response is a number.
std::string options_json_of(const Trial& trial);

}  // namespace asperity
