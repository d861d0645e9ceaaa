// Writes one row per answer, and several for a multiple choice; a question not asked has a row too.

#include "app/session/questionnaire_rows.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace asperity {

std::vector<ResponseRow> rows_of(const Question& question, const FormAnswer& answer,
                                 const AnswerCircumstances& how) {
  ResponseRow row{.question = question.name,
                  .options_json = nlohmann::json(question.options).dump(),
                  .time_ns = how.time_ns,
                  .from_cue_s = how.from_cue_s,
                  .source = how.source};
  if (answer.empty()) return {row};
  std::vector<ResponseRow> rows{};
  for (const std::string& value : answer) {
    row.answer = value;
    row.answer_number = number_of(question, value);
    if (question.form == Question::Form::multiple_choice) {
      const auto option = std::find(question.options.begin(), question.options.end(), value);
      row.item = static_cast<int>(option - question.options.begin()) + 1;
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<ResponseRow> row_not_asked(const Question& question, std::int64_t time_ns) {
  return rows_of(question, {}, {.time_ns = time_ns, .source = std::string(kNotAsked)});
}

QuestionnaireAnswers::QuestionnaireAnswers(const std::vector<ResponseRow>& rows) {
  std::vector<const ResponseRow*> in_order{};
  for (const ResponseRow& row : rows) in_order.push_back(&row);
  std::stable_sort(in_order.begin(), in_order.end(),
                   [](const auto* one, const auto* other) { return one->item < other->item; });
  for (const ResponseRow* const row : in_order) {
    Stored& stored = stored_[row->question];
    if (!row->answer.empty()) stored.answer.push_back(row->answer);
    if (row->source == kNotAsked) stored.was_asked = false;
  }
}

std::vector<std::string> QuestionnaireAnswers::questions() const {
  std::vector<std::string> names{};
  for (const auto& [name, stored] : stored_) names.push_back(name);
  return names;
}

bool QuestionnaireAnswers::was_not_asked(const std::string& question) const {
  const auto found = stored_.find(question);
  return found != stored_.end() && !found->second.was_asked;
}

FormAnswer QuestionnaireAnswers::to(const std::string& question) const {
  const auto found = stored_.find(question);
  return found == stored_.end() ? FormAnswer{} : found->second.answer;
}

}  // namespace asperity
