// Reads the answer to a question from what was typed, at a terminal or in a window.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "app/session/respondents/participant_scene.h"
#include "protocols/answers/question.h"

namespace asperity {

/// An answer, nothing where the question was left empty, or the message shown to a participant whose answer is not
/// acceptable.
using TypedAnswer = std::variant<ParticipantMessage, std::optional<Answer>>;

/// The answer that was typed. An option is typed as its number, in the questionnaire also as its value or text; several options as their
/// numbers, separated by blanks or commas; a point of a scale as its value; a line as a row of at most kLongestTypedLine
/// signs "-". A decimal comma of a number is read as a point. An empty text leaves an optional question empty.
///
/// Errors: std::logic_error for an assignment, which takes one text for each surface (AssignmentDialogue).
TypedAnswer typed_answer(const Question& question, const std::string& typed);

/// Stands for the longest line: its width on the screen of a terminal is unknown.
inline constexpr std::size_t kLongestTypedLine = 50;

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
