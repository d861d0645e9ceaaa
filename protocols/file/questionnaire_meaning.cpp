// Implements the checks that the questions of the questionnaire can be asked and answered, and that the conditions of
// questions and screens can be met.

#include <algorithm>
#include <cstddef>

#include "protocols/file/meaning_checks.h"

namespace asperity {

void Meaning::check_questions() {
  for (const auto& [name, question] : protocol_.questions) {
    const std::string pointer = pointer_to("/questions", name);
    check_question_form(question, pointer);
    check_options(question, pointer);
  }
  check_participant_questions();
}

void Meaning::check_question_form(const Question& question, const std::string& pointer) {
  const auto& object = document_.root().at("questions").at(question.name);
  const auto allow = [&](bool is_allowed, const char* key, const char* reason) {
    if (is_allowed || !object.contains(key)) return;
    report_key(pointer + "/" + key, std::string(reason) + "; remove this key");
  };
  const bool is_number = question.form == Question::Form::number;
  allow(question.has_options(), "options",
        "only a question of the form \"choice\" or \"multiple_choice\" has options");
  allow(is_number, "minimum", "only a question of the form \"number\" has limits");
  allow(is_number, "maximum", "only a question of the form \"number\" has limits");
  allow(is_number, "unit", "only a question of the form \"number\" has a unit");
  allow(question.form == Question::Form::scale, "scale",
        "only a question of the form \"scale\" has a scale");
  if (question.form == Question::Form::choice && question.options.empty()) {
    report(pointer, "a choice needs \"options\"; add this key");
  }
  if (question.form == Question::Form::multiple_choice && question.options.empty()) {
    report(pointer, "a multiple choice needs \"options\"; add this key");
  }
  if (question.form == Question::Form::scale) {
    if (object.contains("scale")) {
      check_scale_form(question.scale, pointer + "/scale");
    } else {
      report(pointer,
             "a scale needs the key \"scale\", such as \"scale\": {\"minimum\": 1, "
             "\"maximum\": 7, \"points\": 7}; add this key");
    }
  }
  if (is_number && question.minimum && question.maximum && *question.minimum > *question.maximum) {
    report(pointer + "/minimum", "no number is at least " + digits(*question.minimum) +
                                     " and at most " + digits(*question.maximum) +
                                     "; lower the minimum or raise the maximum");
  }
}

void Meaning::check_options(const Question& question, const std::string& pointer) {
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const auto here = question.options.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(question.options.begin(), here, *here) != here) {
      report(pointer_to(pointer + "/options", i),
             in_quotes(*here) + " is listed twice; list it once");
    }
    const auto& texts = question.option_texts;
    if (texts.empty()) continue;
    const auto text = texts.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(texts.begin(), text, *text) != text) {
      report(pointer_to(pointer + "/options", i),
             in_quotes(*text) + " is shown for two options; give each its own text");
    }
    const auto value = std::find(question.options.begin(), question.options.end(), *text);
    if (value != question.options.end() && *value != *here) {
      report(pointer_to(pointer + "/options", i),
             in_quotes(*text) + " is shown for " + in_quotes(*here) +
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
    if (question.form == Question::Form::scale ||
        question.form == Question::Form::multiple_choice) {
      report(pointer,
             "the question " + in_quotes(name) + " is answered by a " +
                 (question.form == Question::Form::scale ? "scale" : "multiple choice") +
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
  const auto& object = document_.root().at(nlohmann::json::json_pointer(pointer));
  std::vector<std::string> tests{};
  for (const char* const key : {"is", "in", "includes"}) {
    if (object.contains(key)) tests.emplace_back(key);
  }
  const bool has_range = object.contains("at_least") || object.contains("at_most");
  if (tests.size() + (has_range ? 1U : 0U) != 1U) {
    report(pointer,
           "a condition states one of \"is\", \"in\", \"includes\", or a range with "
           "\"at_least\", \"at_most\" or both; keep one of them");
    return;
  }
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
  const auto* const one_of = std::get_if<AnswerIsOneOf>(&condition.test);
  const std::size_t values = one_of == nullptr ? 1 : one_of->values.size();
  for (std::size_t i = 0; i < values; ++i) {
    const std::optional<std::string> problem = problem_with(condition, question->second, i);
    if (!problem) continue;
    if (has_range) {
      report(pointer + (object.contains("at_least") ? "/at_least" : "/at_most"), *problem);
    } else if (tests.front() == "in") {
      report(pointer_to(pointer + "/in", i), *problem);
    } else {
      report(pointer + "/" + tests.front(), *problem);
    }
  }
}

}  // namespace asperity
