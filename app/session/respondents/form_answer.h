// Whether a typed text answers a question of a form.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/session/respondents/participant_scene.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The sentence shown to a participant whose answer is not acceptable; nothing when it is.
/// `answer` may be the number of an option; it is then replaced by the option. A decimal comma
/// of a number is replaced by a point.
std::optional<Saying> refusal_of(const Question& question, std::string& answer);

/// A number that was typed with a decimal comma, with a point, as numbers are stored; any other text unchanged, also
/// one that might be thousands (is_unclear_estimate).
std::string with_decimal_point(const std::string& typed);
/// The number above 0 that was typed, its decimals after a point or a comma; nothing when it is none,
/// and when it might be thousands (is_unclear_estimate).
std::optional<double> estimate_in(const std::string& text);
/// "1,000", "12.500": one to three digits of which the first is no 0, a point or a comma, and three
/// more. Some people mean thousands by it, others decimals.
bool is_unclear_estimate(const std::string& text);

/// What was typed, without the blanks and line ends around it.
std::string trimmed(const std::string& text);
/// The whole text as a number without sign; nothing when it is not one.
std::optional<std::size_t> whole_number(const std::string& text);

}  // namespace asperity
