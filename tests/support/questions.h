// Questions and answers as tests write them: options and answers by their values.

#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocols/answers/question.h"

namespace asperity {

/// Options that are shown as they are stored.
inline std::vector<Option> in_words(std::initializer_list<const char*> values) {
  std::vector<Option> options{};
  for (const char* const value : values) options.push_back({.value = value, .text = value});
  return options;
}

inline std::vector<std::string> values_of(const std::vector<Option>& options) {
  std::vector<std::string> values{};
  for (const Option& option : options) values.push_back(option.value);
  return values;
}

/// The answer with these stored texts; nothing without texts.
inline std::optional<Answer> answer_with(const Question& question, const FormAnswer& texts) {
  if (texts.empty()) return std::nullopt;
  const std::string& first = texts.front();
  if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
    return ScalePoint{scale->stored_step(first).value()};
  }
  if (question.is_answered_by<NumberForm>()) return GivenNumber{std::stod(first)};
  if (question.is_answered_by<TextForm>()) return WrittenText{first};
  if (question.is_answered_by<ChoiceForm>()) return ChosenOption{question.option_of(first).value()};
  ChosenOptions chosen{};
  for (const std::string& text : texts) chosen.options.push_back(question.option_of(text).value());
  return chosen;
}

/// How an answer is stored.
inline FormAnswer stored(const Question& question, const std::optional<Answer>& answer) {
  return answer ? texts_of(items_of(question, *answer)) : FormAnswer{};
}

}  // namespace asperity
