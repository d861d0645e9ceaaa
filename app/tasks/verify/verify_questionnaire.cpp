// Follows the conditions of the questions, and compares each answer with its question.

#include "app/tasks/verify/verify_questionnaire.h"

#include <algorithm>

#include "app/records/recorded_attempt.h"
#include "app/session/response_rows.h"

namespace asperity {
namespace {

bool is_of_virtual_participant(const std::vector<ResponseRow>& rows, const std::string& question) {
  return std::any_of(rows.begin(), rows.end(), [&question](const ResponseRow& row) {
    return row.question == question && row.source.starts_with("virtual");
  });
}

}  // namespace

std::vector<std::string> answer_problems(const Question& question,
                                         std::span<const AnsweredItem> stored, bool was_asked,
                                         bool is_condition_met, int surfaces) {
  std::vector<std::string> problems{};
  if (was_asked) problems = problems_with(question, stored, surfaces);
  if (!was_asked && !texts_of(stored).empty()) {
    problems.emplace_back("it was not asked, and an answer is stored");
  }
  if (was_asked == is_condition_met) return problems;
  problems.push_back(was_asked ? "it was asked, but the condition that " +
                                     clause_of(*question.condition) + " is not met"
                     : question.condition
                         ? "it was not asked, but " + clause_of(*question.condition)
                         : "it was not asked, but it has no condition");
  return problems;
}

std::vector<std::string> questionnaire_problems(const SessionRow& session, const Protocol& protocol,
                                                const std::vector<ResponseRow>& rows) {
  const StoredAnswers stored(rows);
  std::vector<std::string> problems{};
  const auto report = [&](const std::string& name, const std::string& what) {
    problems.push_back(session_name(session) + ", question " + name + ": " + what);
  };
  for (const std::string& name : stored.questions()) {
    const auto found = protocol.questions.find(name);
    if (found == protocol.questions.end()) {
      report(name, "the protocol has no such question");
      continue;
    }
    const Question& question = found->second;
    const bool was_asked = !stored.was_not_asked(name);
    // Virtual participants write no texts, whether or not the protocol requires one.
    if (was_asked && question.is_answered_by<TextForm>() && stored.to(name).empty() &&
        is_of_virtual_participant(rows, name)) {
      continue;
    }
    for (const std::string& problem : answer_problems(question, stored.items(name), was_asked,
                                                      stored.meet(question.condition))) {
      report(name, problem);
    }
  }
  return problems;
}

}  // namespace asperity
