// Follows the conditions of the questions, and compares each answer with the options.

#include "app/tasks/verify/verify_questionnaire.h"

#include <algorithm>

#include "app/session/questionnaire_rows.h"

namespace asperity {
namespace {

bool is_of_virtual_participant(const std::vector<ResponseRow>& rows, const std::string& question) {
  return std::any_of(rows.begin(), rows.end(), [&question](const ResponseRow& row) {
    return row.question == question && row.source.starts_with("virtual");
  });
}

}  // namespace

std::vector<std::string> questionnaire_problems(const SessionRow& session, const Protocol& protocol,
                                                const std::vector<ResponseRow>& rows) {
  const QuestionnaireAnswers stored(rows);
  std::vector<std::string> problems{};
  const auto report = [&](const std::string& name, const std::string& what) {
    problems.push_back("session " + std::to_string(session.session) + " of participant " +
                       session.participant + ", question " + name + ": " + what);
  };
  for (const std::string& name : stored.questions()) {
    const auto found = protocol.questions.find(name);
    if (found == protocol.questions.end()) {
      report(name, "the protocol has no such question");
      continue;
    }
    const Question& question = found->second;
    const bool should_be_asked =
        !question.condition || is_met(*question.condition, stored.to(question.condition->question));
    const bool was_asked = !stored.was_not_asked(name);
    if (was_asked && !should_be_asked) {
      report(name, "it was asked, but the condition that " + clause_of(*question.condition) +
                       " is not met");
    }
    if (!was_asked && should_be_asked) {
      report(name, question.condition ? "it was not asked, but " + clause_of(*question.condition)
                                      : std::string("it was not asked, but it has no condition"));
    }
    if (!was_asked) {
      if (!stored.to(name).empty()) report(name, "it was not asked, and an answer is stored");
      continue;
    }
    // Virtual participants write no texts, whether or not the protocol requires one.
    if (question.form == Question::Form::text && stored.to(name).empty() &&
        is_of_virtual_participant(rows, name)) {
      continue;
    }
    for (const std::string& problem : problems_with(question, stored.to(name))) {
      report(name, problem);
    }
  }
  return problems;
}

}  // namespace asperity
