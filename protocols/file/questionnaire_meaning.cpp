// Implements the checks that the questions of the questionnaire can be asked and answered, and that the conditions of
// questions and screens can be met.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "protocols/file/meaning_checks.h"

namespace asperity {

void Meaning::check_questions() {
  for (const auto& [name, question] : protocol_.questions) {
    const std::string pointer = pointer_to("/questions", name);
    check_form(question, pointer, OptionsOfChoice::stated);
    check_options(question, pointer);
  }
  check_participant_questions();
}

void Meaning::check_form(const Question& question, const std::string& pointer,
                         OptionsOfChoice options) {
  const auto& object = document_.root().at(nlohmann::json::json_pointer(pointer));
  const auto found = object.find("form");
  // A key of another form has changed the form of the question.
  const std::string stated = found == object.end() ? std::string() : found->get<std::string>();
  const auto allow = [&](const auto& form, const char* key, const char* reason) {
    if (stated == form.kName || !object.contains(key)) return;
    report_key(pointer + "/" + key, std::string(reason) + "; remove this key");
  };
  allow(NumberForm{}, "minimum", "only a question of the form \"number\" has limits");
  allow(NumberForm{}, "maximum", "only a question of the form \"number\" has limits");
  allow(NumberForm{}, "unit", "only a question of the form \"number\" has a unit");
  if (!stated.empty()) {
    allow(ScaleForm{}, "scale", "only a question of the form \"scale\" has a scale");
    allow(LineForm{}, "line", "only a question of the form \"line\" has a line");
    if (stated != MultipleChoiceForm::kName) {
      allow(ChoiceForm{}, "options",
            "only a question of the form \"choice\" or \"multiple_choice\" has options");
    }
  }
  const bool has_several = stated == MultipleChoiceForm::kName;
  const bool needs_options =
      has_several || (stated == ChoiceForm::kName && options == OptionsOfChoice::stated);
  if (needs_options && question.options.empty()) {
    report(pointer, std::string(has_several ? "a multiple choice" : "a choice") +
                        " needs \"options\"; add this key");
  }
  if (stated == ScaleForm::kName && !object.contains("scale")) {
    report(pointer,
           "a scale needs the key \"scale\", such as \"scale\": {\"minimum\": 1, "
           "\"maximum\": 7, \"points\": 7}; add this key");
  } else if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
    if (stated.empty() || stated == ScaleForm::kName) check_scale_form(*scale, pointer + "/scale");
  }
  const auto* const number = std::get_if<NumberForm>(&question.form);
  if (number != nullptr && number->minimum && number->maximum &&
      *number->minimum > *number->maximum) {
    report(pointer + "/minimum", "no number is at least " + digits(*number->minimum) +
                                     " and at most " + digits(*number->maximum) +
                                     "; lower the minimum or raise the maximum");
  }
}

void Meaning::check_options(const Question& question, const std::string& pointer) {
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
      report(at, in_quotes(here.value) + " is listed twice; list it once");
    } else if (is_in(earlier, &Option::text, here.text)) {
      report(at, in_quotes(here.text) + " is shown for two options; give each its own text");
    }
    if (here.text != here.value && is_in(question.options, &Option::value, here.text)) {
      report(at, in_quotes(here.text) + " is shown for " + in_quotes(here.value) +
                     " and stored for another option: give them different words");
    }
  }
}

/// These are asked in a form of the start page, all at once.
void Meaning::check_participant_questions() {
  const auto& root = document_.root();
  if (!root.contains("participants") || !root.at("participants").contains("questions")) return;
  const auto& asked = root.at("participants").at("questions");
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto name = asked[i].get<std::string>();
    const std::string pointer = pointer_to("/participants/questions", i);
    const auto found = protocol_.questions.find(name);
    if (found == protocol_.questions.end()) {
      report(pointer, unknown_name("question", name, protocol_.questions));
      continue;
    }
    const Question& question = found->second;
    const std::string remedy = "; ask it in the flow, with {\"ask\": [" + in_quotes(name) + "]}";
    if (question.condition) {
      report(pointer, "the question " + in_quotes(name) +
                          " has a condition, and the questions about the participant are asked "
                          "together, before the session" +
                          remedy);
    }
    const bool has_field = question.is_answered_by<ChoiceForm>() ||
                           question.is_answered_by<NumberForm>() ||
                           question.is_answered_by<TextForm>();
    if (!has_field) {
      report(pointer,
             "the question " + in_quotes(name) + " is answered by " +
                 std::string(description_of(question.form)) +
                 ", and a question about the participant by one option, a number or a text" +
                 remedy);
    }
  }
}

/// The questions of the flow are asked in order: each condition has to refer to an earlier one.
void Meaning::check_conditions() {
  std::set<std::string> asked{};
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    if (const auto* const screen = std::get_if<Protocol::Screen>(&protocol_.flow[i])) {
      if (screen->condition) {
        check_condition(*screen->condition, asked, pointer_to("/flow", i) + "/if");
      }
    }
    const auto* const ask = std::get_if<Protocol::Ask>(&protocol_.flow[i]);
    if (ask == nullptr) continue;
    for (const std::string& name : ask->questions) {
      const auto question = protocol_.questions.find(name);
      // A question is asked once; in a later step of the flow it is already answered.
      const bool is_new = !asked.contains(name);
      if (is_new && question != protocol_.questions.end() && question->second.condition) {
        check_condition(*question->second.condition, asked, pointer_to("/questions", name) + "/if");
      }
      asked.insert(name);
    }
  }
}

void Meaning::check_condition(const AnswerCondition& condition, const std::set<std::string>& asked,
                              const std::string& pointer) {
  if (!states_one_test(pointer)) return;
  const auto question = protocol_.questions.find(condition.question);
  const std::string at_question = pointer + "/question";
  if (question == protocol_.questions.end()) {
    report(at_question, unknown_name("question", condition.question, protocol_.questions));
    return;
  }
  if (!asked.contains(condition.question)) {
    report(at_question,
           "the flow does not ask the question " + in_quotes(condition.question) +
               " before; ask it in an earlier step of the flow, or earlier in the same one");
  }
  check_test(condition, question->second, pointer);
}

bool Meaning::states_one_test(const std::string& pointer) {
  const auto& object = document_.root().at(nlohmann::json::json_pointer(pointer));
  const auto tests = std::ranges::count_if(std::array{"is", "in", "includes"},
                                           [&](const char* key) { return object.contains(key); });
  const bool has_range = object.contains("at_least") || object.contains("at_most");
  if (tests + (has_range ? 1 : 0) == 1) return true;
  report(pointer,
         "a condition states one of \"is\", \"in\", \"includes\", or a range with "
         "\"at_least\", \"at_most\" or both; keep one of them");
  return false;
}

void Meaning::check_test(const AnswerCondition& condition, const Question& question,
                         const std::string& pointer) {
  const auto& object = document_.root().at(nlohmann::json::json_pointer(pointer));
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
    report(pointer + place, *problem);
  }
}

}  // namespace asperity
