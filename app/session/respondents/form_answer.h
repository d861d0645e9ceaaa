// Checks whether a typed text answers a question of a form.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/session/respondents/participant_scene.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The message shown to a participant whose answer is not acceptable; nothing when it is. `answer`
/// may be the number of an option; it is then replaced by the option. A decimal comma of a number
/// is replaced by a point.
std::optional<Saying> refusal_of(const Question& question, std::string& answer);

/// A number typed with a decimal comma, with a decimal point, as numbers are stored. Any other text
/// is returned unchanged, including one that might contain thousands (is_unclear_estimate).
std::string with_decimal_point(const std::string& typed);
/// The typed number above 0, with a decimal point or comma; nothing when it is not one, and when it
/// might contain thousands (is_unclear_estimate).
std::optional<double> estimate_in(const std::string& text);
/// "1,000", "12.500": one to three digits of which the first is not 0, a point or a comma, and
/// three more digits. The separator may be meant as a thousands or as a decimal separator.
bool is_unclear_estimate(const std::string& text);

/// The typed text without surrounding blanks and line ends.
std::string trimmed(const std::string& text);
/// The whole text as a number without sign; nothing when it is not one.
std::optional<std::size_t> whole_number(const std::string& text);

}  // namespace asperity
