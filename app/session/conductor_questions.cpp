// The part of Conductor that asks the questions of the questionnaire.

#include <string>
#include <vector>

#include "app/session/conductor.h"
#include "app/session/response_rows.h"

namespace asperity {

void Conductor::ask(const Protocol::Ask& questions) {
  for (const std::string& name : questions.questions) {
    const StoredAnswers answered(study_.session_answers(session_.row.id));
    if (answered.has(name)) continue;  // before the interruption
    hold(Next::other);
    if (stopped_) return;
    const Question& question = protocol_.questions.at(name);
    if (!answered.meet(question.condition)) {
      store_answer(row_not_asked(question, course_.now_ns()));
      continue;
    }
    course_.enter(SessionPhase::questions);
    course_.put_mask(false, outside_);
    course_.show(scene_of_form(question));
    const std::int64_t cue_ns = course_.now_ns();
    const std::optional<Answer> answer = respondent_.answer(question, outside_);
    const std::int64_t time_ns = respondent_.answered_ns().value_or(course_.now_ns());
    store_answer(rows_of(question, answer,
                         {.time_ns = time_ns,
                          .from_cue_s = seconds_between(cue_ns, time_ns),
                          .source = respondent_.source()}));
  }
}

bool Conductor::holds(const std::optional<AnswerCondition>& condition) const {
  return StoredAnswers(study_.session_answers(session_.row.id)).meet(condition);
}

void Conductor::store_answer(const std::vector<ResponseRow>& items) {
  study_.add_session_answer(session_.row.id, items);
}

}  // namespace asperity
