// Writes one row per item of an answer; a question that was left empty or not asked has a row too.

#include "app/session/response_rows.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "protocols/plan/shown_options.h"

namespace asperity {

std::vector<ResponseRow> rows_of(const Question& question, const std::optional<Answer>& answer,
                                 const AnswerCircumstances& how) {
  std::vector<AnsweredItem> items{};
  if (answer) items = items_of(question, *answer);
  if (items.empty()) items.emplace_back();
  std::vector<ResponseRow> rows{};
  for (AnsweredItem& item : items) {
    rows.push_back({.question = question.name,
                    .item = item.item,
                    .answer = std::move(item.answer),
                    .answer_number = item.number,
                    .correct = item.correct,
                    .options_json = options_json_of(question),
                    .time_ns = how.time_ns,
                    .from_contact_s = how.from_contact_s,
                    .from_cue_s = how.from_cue_s,
                    .source = how.source});
  }
  return rows;
}

std::vector<ResponseRow> row_not_asked(const Question& question, std::int64_t time_ns) {
  return rows_of(question, {}, {.time_ns = time_ns, .source = std::string(kNotAsked)});
}

StoredAnswers::StoredAnswers(const std::vector<ResponseRow>& rows) {
  for (const ResponseRow& row : rows) {
    Stored& stored = stored_[row.question];
    stored.items.push_back({.item = row.item,
                            .answer = row.answer,
                            .number = row.answer_number,
                            .correct = row.correct});
    if (row.source == kNotAsked) stored.was_asked = false;
  }
  for (auto& [name, stored] : stored_) {
    std::ranges::stable_sort(stored.items, std::less{}, &AnsweredItem::item);
  }
}

std::vector<std::string> StoredAnswers::questions() const {
  std::vector<std::string> names{};
  for (const auto& [name, stored] : stored_) names.push_back(name);
  return names;
}

bool StoredAnswers::was_not_asked(const std::string& question) const {
  const auto found = stored_.find(question);
  return found != stored_.end() && !found->second.was_asked;
}

std::vector<AnsweredItem> StoredAnswers::items(const std::string& question) const {
  const auto found = stored_.find(question);
  return found == stored_.end() ? std::vector<AnsweredItem>{} : found->second.items;
}

FormAnswer StoredAnswers::to(const std::string& question) const {
  return texts_of(items(question));
}

bool StoredAnswers::meet(const std::optional<AnswerCondition>& condition) const {
  return !condition || is_met(*condition, to(condition->question));
}

}  // namespace asperity
