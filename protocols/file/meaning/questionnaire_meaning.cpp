// Implements the checks that the questions of the questionnaire can be asked and answered, and that the conditions of
// questions and screens can be met.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

namespace {

/// These are asked in a form of the start page, all at once.
void check_participant_questions(CheckedDocument& checked) {
  const auto& root = checked.document.root();
  if (!root.contains("participants") || !root.at("participants").contains("questions")) return;
  const auto& asked = root.at("participants").at("questions");
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto name = asked[i].get<std::string>();
    const std::string pointer = pointer_to("/participants/questions", i);
    const auto found = checked.protocol.questions.find(name);
    if (found == checked.protocol.questions.end()) {
      checked.report(pointer, unknown_name("question", name, checked.protocol.questions));
      continue;
    }
    const Question& question = found->second;
    const std::string remedy = "; ask it in the flow, with {\"ask\": [" + in_quotes(name) + "]}";
    if (question.condition) {
      checked.report(pointer,
                     "the question " + in_quotes(name) +
                         " has a condition, and the questions about the participant are asked "
                         "together, before the session" +
                         remedy);
    }
    const bool has_field = question.is_answered_by<ChoiceForm>() ||
                           question.is_answered_by<NumberForm>() ||
                           question.is_answered_by<TextForm>();
    if (!has_field) {
      checked.report(
          pointer, "the question " + in_quotes(name) + " is answered by " +
                       std::string(description_of(question.form)) +
                       ", and a question about the participant by one option, a number or a text" +
                       remedy);
    }
  }
}

/// `asked`: the questions that the flow asks before.
void check_condition(CheckedDocument& checked, const AnswerCondition& condition,
                     const std::set<std::string>& asked, const std::string& pointer) {
  if (!states_one_test(checked, pointer)) return;
  const auto question = checked.protocol.questions.find(condition.question);
  const std::string at_question = pointer + "/question";
  if (question == checked.protocol.questions.end()) {
    checked.report(at_question,
                   unknown_name("question", condition.question, checked.protocol.questions));
    return;
  }
  if (!asked.contains(condition.question)) {
    checked.report(
        at_question,
        "the flow does not ask the question " + in_quotes(condition.question) +
            " before; ask it in an earlier step of the flow, or earlier in the same one");
  }
  check_test(checked, condition, question->second, pointer);
}

}  // namespace

void check_questions(CheckedDocument& checked) {
  for (const auto& [name, question] : checked.protocol.questions) {
    const std::string pointer = pointer_to("/questions", name);
    check_form(checked, question, pointer, OptionsOfChoice::stated);
    check_options(checked, question, pointer);
  }
  check_participant_questions(checked);
}

void check_form(CheckedDocument& checked, const Question& question, const std::string& pointer,
                OptionsOfChoice options) {
  const auto& object = checked.document.root().at(nlohmann::json::json_pointer(pointer));
  const auto found = object.find("form");
  const std::string stated = found == object.end() ? std::string() : found->get<std::string>();
  const bool has_several = stated == MultipleChoiceForm::kName;
  const bool needs_options =
      has_several || (stated == ChoiceForm::kName && options == OptionsOfChoice::stated);
  if (needs_options && question.options.empty()) {
    checked.report(pointer, std::string(has_several ? "a multiple choice" : "a choice") +
                                " needs \"options\"; add this key");
  }
  if (stated == ScaleForm::kName && !object.contains("scale")) {
    checked.report(pointer,
                   "a scale needs the key \"scale\", such as \"scale\": {\"minimum\": 1, "
                   "\"maximum\": 7, \"points\": 7}; add this key");
  } else if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
    check_scale_form(checked, *scale, pointer + "/scale");
  }
  const auto* const number = std::get_if<NumberForm>(&question.form);
  if (number != nullptr && number->minimum && number->maximum &&
      *number->minimum > *number->maximum) {
    checked.report(pointer + "/minimum", "no number is at least " + digits(*number->minimum) +
                                             " and at most " + digits(*number->maximum) +
                                             "; lower the minimum or raise the maximum");
  }
}

void check_options(CheckedDocument& checked, const Question& question, const std::string& pointer) {
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const Option& here = question.options[i];
    const std::string at = pointer_to(pointer + "/options", i);
    const auto earlier = std::span(question.options).first(i);
    const auto is_in = [](const auto& options, const std::string Option::*what,
                          const std::string& text) {
      return std::any_of(options.begin(), options.end(),
                         [&](const Option& each) { return each.*what == text; });
    };
    if (is_in(earlier, &Option::value, here.value)) {
      checked.report(at, in_quotes(here.value) + " is listed twice; list it once");
    } else if (is_in(earlier, &Option::text, here.text)) {
      checked.report(at,
                     in_quotes(here.text) + " is shown for two options; give each its own text");
    }
    if (here.text != here.value && is_in(question.options, &Option::value, here.text)) {
      checked.report(at, in_quotes(here.text) + " is shown for " + in_quotes(here.value) +
                             " and stored for another option: give them different words");
    }
  }
}

/// The questions of the flow are asked in order: each condition has to refer to an earlier one.
void check_conditions(CheckedDocument& checked) {
  std::set<std::string> asked{};
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    if (const auto* const screen = std::get_if<Protocol::Screen>(&checked.protocol.flow[i])) {
      if (screen->condition) {
        check_condition(checked, *screen->condition, asked, pointer_to("/flow", i) + "/if");
      }
    }
    const auto* const ask = std::get_if<Protocol::Ask>(&checked.protocol.flow[i]);
    if (ask == nullptr) continue;
    for (const std::string& name : ask->questions) {
      const auto question = checked.protocol.questions.find(name);
      // A question is asked once; in a later step of the flow it is already answered.
      const bool is_new = !asked.contains(name);
      if (is_new && question != checked.protocol.questions.end() && question->second.condition) {
        check_condition(checked, *question->second.condition, asked,
                        pointer_to("/questions", name) + "/if");
      }
      asked.insert(name);
    }
  }
}

bool states_one_test(CheckedDocument& checked, const std::string& pointer) {
  const auto& object = checked.document.root().at(nlohmann::json::json_pointer(pointer));
  const auto tests = std::ranges::count_if(std::array{"is", "in", "includes"},
                                           [&](const char* key) { return object.contains(key); });
  const bool has_range = object.contains("at_least") || object.contains("at_most");
  if (tests + (has_range ? 1 : 0) == 1) return true;
  checked.report(pointer,
                 "a condition states one of \"is\", \"in\", \"includes\", or a range with "
                 "\"at_least\", \"at_most\" or both; keep one of them");
  return false;
}

void check_test(CheckedDocument& checked, const AnswerCondition& condition,
                const Question& question, const std::string& pointer) {
  const auto& object = checked.document.root().at(nlohmann::json::json_pointer(pointer));
  const auto* const one_of = std::get_if<AnswerIsOneOf>(&condition.test);
  const std::size_t values = one_of == nullptr ? 1 : one_of->values.size();
  for (std::size_t i = 0; i < values; ++i) {
    const std::optional<std::string> problem = problem_with(condition, question, i);
    if (!problem) continue;
    std::string place = "/at_most";
    for (const char* const key : {"at_least", "includes", "is"}) {
      if (object.contains(key)) place = std::string("/") + key;
    }
    if (object.contains("in")) place = "/in/" + std::to_string(i);
    checked.report(pointer + place, *problem);
  }
}

}  // namespace asperity
