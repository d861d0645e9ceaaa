// Reads questions of the questionnaire, their conditions and scales from JSON that follows the schema.

#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "protocols/answers/question.h"
#include "protocols/answers/scale_form.h"

namespace asperity {

Question question_of(const std::string& name, const nlohmann::json& object);
ScaleForm scale_of(const nlohmann::json& object);
/// The condition "if" of a question or a screen; nothing where there is none.
std::optional<AnswerCondition> condition_in(const nlohmann::json& object);

}  // namespace asperity
