// The answers to the questions of trials and of the questionnaire, as rows of the tables `response` and `session_answer`.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/answers/question.h"
#include "results_schema/rows.h"

namespace asperity {

/// When and how an answer was given.
struct AnswerCircumstances {
  std::int64_t time_ns = 0;
  std::optional<double> from_contact_s{};
  std::optional<double> from_cue_s{};
  std::string source{};
};

/// One row per item of the answer; one without an answer where the question was left empty.
std::vector<ResponseRow> rows_of(const Question& question, const std::optional<Answer>& answer,
                                 const AnswerCircumstances& how);
std::vector<ResponseRow> row_not_asked(const Question& question, std::int64_t time_ns);

/// The stored answers of one session to the questionnaire, or of one attempt at a trial, by question.
class StoredAnswers final {
 public:
  explicit StoredAnswers(const std::vector<ResponseRow>& rows);

  /// Whether anything is stored: an answer, that it was left empty, or that it was not asked.
  bool has(const std::string& question) const { return stored_.contains(question); }
  /// The questions of which anything is stored, by name.
  std::vector<std::string> questions() const;
  bool was_not_asked(const std::string& question) const;
  /// Empty where the question was left empty or not asked, and where nothing is stored.
  FormAnswer to(const std::string& question) const;
  /// In their order; without items where nothing is stored.
  std::vector<AnsweredItem> items(const std::string& question) const;
  /// An absent condition is always met.
  bool meet(const std::optional<AnswerCondition>& condition) const;

 private:
  struct Stored {
    std::vector<AnsweredItem> items{};
    bool was_asked = true;
  };
  std::map<std::string, Stored, std::less<>> stored_{};
};

}  // namespace asperity
