// Declares the JSON of the shown options, which is stored with every response.

#pragma once

#include <string>

#include "protocols/answers/question.h"

namespace asperity {

/// The JSON of the values of a question's options, in the order in which they are shown; "[]" if it has none.
std::string options_json_of(const Question& question);

}  // namespace asperity
