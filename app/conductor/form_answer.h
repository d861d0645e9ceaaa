// Whether what somebody wrote answers a question of a form.

#pragma once

#include <optional>
#include <string>

#include "app/conductor/participant_scene.h"
#include "protocols/protocol.h"

namespace asperity {

/// Why an answer is not acceptable; nothing when it is. `answer` may be the number of an option; it
/// is then replaced by the option.
std::optional<Saying> complaint_about_answer(const Question& question, std::string& answer);

}  // namespace asperity
