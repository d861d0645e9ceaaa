// Implements the checks that the questions of the questionnaire can be asked and answered, and that the conditions of
// questions and screens can be met.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "analysis/numbers/overloaded.h"
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
    const std::string asked_alone = "{\"ask\": [" + in_quotes(name) + "]}";
    if (question.condition) {
      checked.report(pointer,
                     phrase("Protocols",
                            "the question %1 has a condition, and the questions about the "
                            "participant are asked together, before the session; ask it in the "
                            "flow%2")
                         .with(in_quotes(name), with_json(asked_alone)));
    }
    const bool has_field = question.is_answered_by<ChoiceForm>() ||
                           question.is_answered_by<NumberForm>() ||
                           question.is_answered_by<TextForm>();
    if (!has_field) {
      checked.report(
          pointer,
          phrase("Protocols",
                 "the question %1 is answered by %2, and a question about the participant by one "
                 "option, a number or a text; ask it in the flow%3")
              .with(in_quotes(name), description_of(question.form), with_json(asked_alone)));
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
        phrase("Protocols",
               "the flow does not ask the question %1 before; ask it in an earlier step of the "
               "flow, or earlier in the same one")
            .with(in_quotes(condition.question)));
  }
  check_test(checked, condition, question->second, pointer);
}

/// In quotation marks, if it is not a number.
std::string quoted_value(const AnswerValue& value) {
  const auto* const number = std::get_if<double>(&value);
  return number != nullptr ? digits(*number) : in_quotes(std::get<std::string>(value));
}

Phrase not_an_option(const AnswerValue& value, const Question& question) {
  std::vector<std::string> options{};
  for (const Option& option : question.options) options.push_back(option.value);
  return options.empty()
             ? phrase("Protocols",
                      "%1 is not an option of the question %2; state the options of that question")
                   .with(quoted_value(value), in_quotes(question.name))
             : phrase("Protocols", "%1 is not an option of the question %2; use %3")
                   .with(quoted_value(value), in_quotes(question.name),
                         joined_by_or(quoted(options)));
}

Phrase other_test(const Question& question) {
  if (question.is_answered_by<MultipleChoiceForm>()) {
    return phrase("Protocols", "state %1").with(key_name("includes"));
  }
  if (question.is_answered_by<ChoiceForm>() || numbers_of(question.form)) {
    return phrase("Protocols", "state %1 or %2").with(key_name("is"), key_name("in"));
  }
  return phrase("Protocols", "refer to another question");
}

std::optional<Phrase> problem_with_value(const AnswerValue& value, const Question& question) {
  const std::string name = in_quotes(question.name);
  if (question.is_answered_by<MultipleChoiceForm>()) {
    return phrase("Protocols",
                  "several options of the question %1 may be chosen; state %2 with one of them")
        .with(name, key_name("includes"));
  }
  const auto* const number = std::get_if<double>(&value);
  if (question.is_answered_by<ChoiceForm>()) {
    if (number == nullptr && question.option_of(std::get<std::string>(value))) return {};
    return not_an_option(value, question);
  }
  const std::optional<NumberRange> range = numbers_of(question.form);
  if (!range) {
    return phrase("Protocols",
                  "the question %1 is answered by %2, which no condition can refer to; refer to "
                  "another question")
        .with(name, description_of(question.form));
  }
  if (number == nullptr) {
    return phrase("Protocols",
                  "%1 is not a number, and the question %2 is answered by %3; state a number")
        .with(quoted_value(value), name, description_of(question.form));
  }
  if ((range->minimum && *number < *range->minimum) ||
      (range->maximum && *number > *range->maximum)) {
    return phrase("Protocols", "%1 cannot be the answer to the question %2; use a number of %3")
        .with(digits(*number), name, range_text(range->minimum, range->maximum));
  }
  const auto* const scale = std::get_if<ScaleForm>(&question.form);
  if (scale == nullptr || scale->can_be_stored_as(digits(*number))) return {};
  return phrase("Protocols",
                "%1 is not a point of the scale of the question %2; the points are %3 apart, from "
                "%4 to %5")
      .with(digits(*number), name, digits(scale->value_at(1) - scale->value_at(0)),
            digits(scale->minimum), digits(scale->maximum));
}

std::optional<Phrase> problem_with_option(const AnswerIncludes& includes,
                                          const Question& question) {
  if (!question.is_answered_by<MultipleChoiceForm>()) {
    return phrase("Protocols",
                  "the question %1 is answered by %2, and only a multiple choice includes options; "
                  "%3")
        .with(in_quotes(question.name), description_of(question.form), other_test(question));
  }
  if (question.option_of(includes.option)) return {};
  return not_an_option(includes.option, question);
}

std::optional<Phrase> problem_with_range(const AnswerWithin& within, const Question& question) {
  const std::optional<NumberRange> range = numbers_of(question.form);
  if (!range) {
    return phrase("Protocols",
                  "the question %1 is answered by %2, and only a number or a scale has a range; %3")
        .with(in_quotes(question.name), description_of(question.form), other_test(question));
  }
  if (within.minimum && within.maximum && *within.minimum > *within.maximum) {
    return phrase("Protocols", "no number is at least %1 and at most %2; exchange the two")
        .with(digits(*within.minimum), digits(*within.maximum));
  }
  const bool is_above = within.minimum && range->maximum && *within.minimum > *range->maximum;
  const bool is_below = within.maximum && range->minimum && *within.maximum < *range->minimum;
  if (!is_above && !is_below) return {};
  return phrase("Protocols", "the answer to the question %1 is %2 and never %3; change the range")
      .with(in_quotes(question.name), range_text(range->minimum, range->maximum),
            range_text(within.minimum, within.maximum));
}

/// What prevents an answer to the question from meeting the condition; nothing where some answer meets it. `value`: of the
/// values of AnswerIsOneOf, the one that is judged.
std::optional<Phrase> problem_with(const AnswerCondition& condition, const Question& question,
                                   std::size_t value) {
  return std::visit(
      Overloaded{
          [&](const AnswerIsOneOf& one_of) {
            return problem_with_value(one_of.values.at(value), question);
          },
          [&](const AnswerIncludes& includes) { return problem_with_option(includes, question); },
          [&](const AnswerWithin& within) { return problem_with_range(within, question); }},
      condition.test);
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
    checked.report(pointer,
                   (has_several ? phrase("Protocols", "a multiple choice needs %1; add this key")
                                : phrase("Protocols", "a choice needs %1; add this key"))
                       .with(key_name("options")));
  }
  if (stated == ScaleForm::kName && !object.contains("scale")) {
    checked.report(pointer, phrase("Protocols", "a scale needs the key %1%2; add this key")
                                .with(key_name("scale"),
                                      such_as_json("\"scale\": {\"minimum\": 1, \"maximum\": 7, "
                                                   "\"points\": 7}")));
  } else if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
    check_scale_form(checked, *scale, pointer + "/scale");
  }
  const auto* const number = std::get_if<NumberForm>(&question.form);
  if (number != nullptr && number->minimum && number->maximum &&
      *number->minimum > *number->maximum) {
    checked.report(pointer + "/minimum",
                   phrase("Protocols",
                          "no number is at least %1 and at most %2; lower the minimum or raise the "
                          "maximum")
                       .with(digits(*number->minimum), digits(*number->maximum)));
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
      checked.report(
          at, phrase("Protocols", "%1 is listed twice; list it once").with(in_quotes(here.value)));
    } else if (is_in(earlier, &Option::text, here.text)) {
      checked.report(at, phrase("Protocols", "%1 is shown for two options; give each its own text")
                             .with(in_quotes(here.text)));
    }
    if (here.text != here.value && is_in(question.options, &Option::value, here.text)) {
      checked.report(
          at, phrase("Protocols",
                     "%1 is shown for %2 and stored for another option: give them different words")
                  .with(in_quotes(here.text), in_quotes(here.value)));
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
  checked.report(
      pointer, phrase("Protocols",
                      "a condition states one of %1, %2, %3, or a range with %4, %5 or both; "
                      "keep one of them")
                   .with(key_name("is"), key_name("in"), key_name("includes"), key_name("at_least"),
                         key_name("at_most")));
  return false;
}

void check_test(CheckedDocument& checked, const AnswerCondition& condition,
                const Question& question, const std::string& pointer) {
  const auto& object = checked.document.root().at(nlohmann::json::json_pointer(pointer));
  const auto* const one_of = std::get_if<AnswerIsOneOf>(&condition.test);
  const std::size_t values = one_of == nullptr ? 1 : one_of->values.size();
  for (std::size_t i = 0; i < values; ++i) {
    const std::optional<Phrase> problem = problem_with(condition, question, i);
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
