#include "protocols/file/question_from_json.h"

#include <utility>

#include "protocols/file/json_reading.h"

namespace asperity {

namespace {

using nlohmann::json;

/// Fills the option texts only if an option has a separate text.
void read_options(const json& object, Question& question) {
  const auto found = object.find("options");
  if (found == object.end()) return;
  for (const json& option : *found) {
    const bool has_text = option.is_object();
    question.options.push_back((has_text ? option.at("value") : option).get<std::string>());
    question.option_texts.push_back((has_text ? option.at("text") : option).get<std::string>());
  }
  if (question.option_texts == question.options) question.option_texts.clear();
}

AnswerValue value_of(const json& value) {
  if (value.is_number()) return value.get<double>();
  return value.get<std::string>();
}

/// The check of the meaning refuses a condition with another number of tests than one.
AnswerCondition condition_of(const json& object) {
  AnswerCondition condition{};
  read(object, "question", condition.question);
  if (const auto is = object.find("is"); is != object.end()) {
    condition.test = AnswerIsOneOf{{value_of(*is)}};
  } else if (const auto in = object.find("in"); in != object.end()) {
    AnswerIsOneOf one_of{};
    for (const json& value : *in) one_of.values.push_back(value_of(value));
    condition.test = std::move(one_of);
  } else if (const auto includes = object.find("includes"); includes != object.end()) {
    condition.test = AnswerIncludes{includes->get<std::string>()};
  } else {
    AnswerWithin within{};
    read(object, "at_least", within.minimum);
    read(object, "at_most", within.maximum);
    condition.test = within;
  }
  return condition;
}

}  // namespace

ScaleForm scale_of(const json& object) {
  ScaleForm scale{};
  read(object, "minimum", scale.minimum);
  read(object, "maximum", scale.maximum);
  read(object, "points", scale.points);
  read(object, "labels", scale.labels);
  return scale;
}

std::optional<AnswerCondition> condition_in(const json& object) {
  const auto found = object.find("if");
  return found == object.end() ? std::nullopt : std::optional(condition_of(*found));
}

Question question_of(const std::string& name, const json& object) {
  Question question{};
  question.name = name;
  read(object, "prompt", question.prompt);
  using Form = Question::Form;
  read_choice(object, "form", question.form,
              {{"choice", Form::choice},
               {"multiple_choice", Form::multiple_choice},
               {"number", Form::number},
               {"scale", Form::scale},
               {"text", Form::text}});
  read_options(object, question);
  read(object, "minimum", question.minimum);
  read(object, "maximum", question.maximum);
  read(object, "unit", question.unit);
  if (const auto found = object.find("scale"); found != object.end()) {
    question.scale = scale_of(*found);
  }
  read(object, "optional", question.optional);
  question.condition = condition_in(object);
  return question;
}

}  // namespace asperity
