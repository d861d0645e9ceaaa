// A participant whose behaviour a test sets.

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/session/respondents/respondent.h"
#include "tests/support/questions.h"
#include "tests/support/replies.h"

namespace asperity {

/// The first option that is correct, or the first that is not.
inline Reply reply_that_is(const Trial& trial, bool correct) {
  const Question& question = trial.questions.front();
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    if ((question.options[i].value == question.correct[0]) == correct) return chooses(i);
  }
  return {};
}
inline Reply correct_reply(const Trial& trial) { return reply_that_is(trial, true); }
inline Reply incorrect_reply(const Trial& trial) { return reply_that_is(trial, false); }

struct PersonPace {
  double reading_s = 0.1;  ///< longer than a text has to be shown
  double answering_s = 0.2;
};

/// Reads everything and answers with the first option, unless a test sets another reply; keeps what it was asked.
class ScriptedPerson : public Respondent {
 public:
  explicit ScriptedPerson(const PersonPace& pace = {}) : pace_(pace) {}

  // --- what it does ---
  /// The reply to the n-th page of questions, `answering_s` after it was put; the trial has only those questions.
  std::function<Reply(int, const Trial&)> at_question{};
  /// The reply to every such question, taking its own time.
  std::function<Reply(const Wait&)> at_ask{};
  /// The answer to a question about the person or the session.
  std::function<FormAnswer(const Question&, const Wait&)> at_form{};
  std::function<void()> at_tell{};
  std::function<AfterFault()> at_fault{};
  bool has_had_enough = false;  ///< of each surface, as soon as it may
  bool is_at_window = false;    ///< wears a mask, and sees nothing that is for the experimenter
  std::optional<std::int64_t> form_answered_ns{};
  std::vector<EventRow> events{};  ///< until they are taken

  // --- what it was asked, in order ---
  std::vector<std::string> calls{};  ///< "read", "surface 2", "ask", "tell", "answer", "mask on"
  std::vector<std::string> texts{};  ///< that it read or was told
  std::vector<std::string> forms{};  ///< names of the questions about the person or the session
  std::vector<int> felt_positions{};
  std::vector<ForceFeatures> last_felt{};
  std::vector<std::optional<double>> deadlines_s{};
  std::vector<std::string> faults_heard{};
  std::vector<ButtonChange> buttons{};
  int questions = 0;

  void read(const std::string& text, double minimum_s, const Wait& wait) override {
    calls.push_back("read");
    texts.push_back(text);
    wait(minimum_s + pace_.reading_s);
  }
  void announce(const Trial&, const PlannedPresentation& surface) override {
    calls.push_back("surface " + std::to_string(surface.position));
    felt_positions.push_back(surface.position);
  }
  Reply ask(const Trial& trial, std::span<const Question> page, std::span<const ForceFeatures> felt,
            std::optional<double> deadline_s, const Wait& wait) override {
    calls.push_back("ask");
    last_felt.assign(felt.begin(), felt.end());
    deadlines_s.push_back(deadline_s);
    ++questions;
    if (at_ask) return at_ask(wait);
    wait(pace_.answering_s);
    if (!at_question) return chooses(0);
    Trial asked = trial;
    asked.questions.assign(page.begin(), page.end());
    return at_question(questions, asked);
  }
  void tell(const std::string& text, const Wait&) override {
    calls.push_back("tell");
    texts.push_back(text);
    if (at_tell) at_tell();
  }
  std::optional<Answer> answer(const Question& question, const Wait& wait) override {
    calls.push_back("answer");
    forms.push_back(question.name);
    if (at_form) return answer_with(question, at_form(question, wait));
    if (question.options.empty()) return std::nullopt;
    return answer_with(question, {question.options.front().value});
  }
  std::optional<std::int64_t> answered_ns() const override { return form_answered_ns; }
  std::string source() const override { return "keyboard"; }
  void begin_attempt(int, int) override {}
  bool wants_next(bool may_go) override { return may_go && has_had_enough; }
  bool wears_mask() const override { return is_at_window; }
  bool leaves_prompts_to_experimenter() const override { return is_at_window; }
  void put_mask(bool on, const Wait& wait) override {
    calls.push_back(on ? "mask on" : "mask off");
    wait(0.1);
  }
  void hear_of_fault(const std::string& what) override { faults_heard.push_back(what); }
  AfterFault after_fault() override { return at_fault ? at_fault() : AfterFault::nothing; }
  void button_changed(const ButtonChange& change) override { buttons.push_back(change); }
  std::vector<EventRow> take_events() override { return std::exchange(events, {}); }

 private:
  PersonPace pace_{};
};

}  // namespace asperity
