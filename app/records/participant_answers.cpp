// Continues the numbers of existing labels, and checks each answer against its question.

#include "app/records/participant_answers.h"

#include <algorithm>
#include <charconv>

#include <nlohmann/json.hpp>

#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr std::string_view kVirtual = "virtual";

/// "P009" as "P" and 9, written with 3 digits.
struct NumberedLabel {
  std::string beginning{};
  long number = 0;
  std::size_t digits = 0;
};

std::optional<NumberedLabel> numbered(const std::string& label) {
  const std::size_t end = label.find_last_not_of("0123456789");
  const std::size_t first = end == std::string::npos ? 0 : end + 1;
  NumberedLabel parts{.beginning = label.substr(0, first), .digits = label.size() - first};
  const char* const begin = label.data() + first;
  const auto read = std::from_chars(begin, label.data() + label.size(), parts.number);
  if (parts.digits == 0 || read.ec != std::errc{}) return {};
  return parts;
}

std::string label_of(const NumberedLabel& label) {
  std::string number = std::to_string(label.number);
  if (number.size() < label.digits) number.insert(0, label.digits - number.size(), '0');
  return label.beginning + number;
}

}  // namespace

std::string suggested_label(const std::vector<ParticipantRow>& participants) {
  struct Series {
    NumberedLabel highest{};
    int people = 0;
  };
  std::map<std::string, Series> series{};
  for (const ParticipantRow& person : participants) {
    if (person.is_virtual) continue;
    const std::optional<NumberedLabel> label = numbered(person.label);
    if (!label) continue;
    Series& same = series[label->beginning];
    ++same.people;
    if (same.people == 1 || label->number > same.highest.number) same.highest = *label;
  }
  if (series.empty()) return "sub001";
  NumberedLabel next =
      std::max_element(series.begin(), series.end(), [](const auto& a, const auto& b) {
        return a.second.people < b.second.people;
      })->second.highest;
  ++next.number;
  return label_of(next);
}

std::string next_virtual_label(const std::vector<ParticipantRow>& participants) {
  NumberedLabel next{.beginning = std::string(kVirtual), .number = 0, .digits = 4};
  for (const ParticipantRow& person : participants) {
    const std::optional<NumberedLabel> label = numbered(person.label);
    if (label && label->beginning == kVirtual) next.number = std::max(next.number, label->number);
  }
  ++next.number;
  return label_of(next);
}

std::optional<Phrase> complaint_about_answer(const Question& question, const std::string& answer) {
  if (answer.empty()) {
    if (question.optional) return {};
    return phrase("ParticipantAnswers", "\"%1\" has not been answered; enter an answer.")
        .with(question.prompt);
  }
  if (question.is_answered_by<ChoiceForm>()) {
    if (question.option_of(answer)) return {};
    return phrase("ParticipantAnswers",
                  "\"%1\" is not one of the answers to \"%2\"; choose one of them.")
        .with(answer, question.prompt);
  }
  // Other forms are not asked about a participant; the protocol is refused.
  const auto* const form = std::get_if<NumberForm>(&question.form);
  if (form == nullptr) return {};
  const std::optional<double> number = number_in(answer);
  if (!number) {
    return phrase("ParticipantAnswers", "The answer to \"%1\" must be a number.")
        .with(question.prompt);
  }
  if (form->minimum && *number < *form->minimum) {
    return phrase("ParticipantAnswers", "The answer to \"%1\" must be %2 or more.")
        .with(question.prompt, text_of_number(*form->minimum));
  }
  if (form->maximum && *number > *form->maximum) {
    return phrase("ParticipantAnswers", "The answer to \"%1\" must be %2 or less.")
        .with(question.prompt, text_of_number(*form->maximum));
  }
  return {};
}

ParticipantRow person_of(const std::string& label, const Protocol& protocol,
                         const ParticipantAnswers& answers, const std::string& created_utc) {
  ParticipantRow person{};
  person.label = label;
  person.created_utc = created_utc;
  nlohmann::ordered_json others = nlohmann::ordered_json::object();
  for (const Question& question : questions_about_participant(protocol)) {
    const auto found = answers.find(question.name);
    if (found == answers.end() || found->second.empty()) continue;
    const std::string& answer = found->second;
    if (question.name == "sex") {
      person.sex = answer == "female" ? "F" : answer == "male" ? "M" : "X";
    } else if (question.name == "handedness") {
      person.handedness = answer == "left" || answer == "right" ? answer : "ambidextrous";
    } else if (question.name == "age") {
      person.age_years = number_in(answer);
    } else {
      others[question.name] = answer;
    }
  }
  person.answers_json = others.dump();
  return person;
}

bool uses_left_hand(const ParticipantRow& person) {
  const auto answers = nlohmann::json::parse(person.answers_json, nullptr, false);
  if (answers.is_object() && answers.contains("hand_used")) {
    return answers.at("hand_used") == "left";
  }
  return person.handedness == "left";
}

}  // namespace asperity
