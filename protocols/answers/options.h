// What the forms with options have in common.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "protocols/answers/trial_question.h"

namespace asperity {

/// Whether `answer` is the correct response of an item; nothing where the question does not determine it.
std::optional<bool> is_correct(const TrialQuestion& question, int item, const std::string& answer);

/// Errors: std::out_of_range for an option that the question does not have.
AnsweredItem chosen_item(const TrialQuestion& question, int item, std::size_t option);

std::vector<std::string> problems_with_option(const TrialQuestion& question,
                                              const AnsweredItem& stored);

/// The label of the option of that value; "?" where there is none.
std::string label_of_option(const TrialQuestion& question, const std::string& value);

}  // namespace asperity
