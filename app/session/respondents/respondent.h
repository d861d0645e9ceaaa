// Interface to the participant of a session: a person at a window or terminal, or a virtual
// participant.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/signals/force_features.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"
#include "results_schema/rows.h"

namespace asperity {

/// Lets time pass while the participant thinks, in seconds. The servo keeps ticking meanwhile.
using Wait = std::function<void(double)>;

/// The deadline passed before an answer was given.
struct NoAnswer {};
/// The participant wishes to feel a surface again.
struct FeelAgain {
  int position = 0;
};

/// The answer to one question of a page.
struct GivenAnswer {
  Answer answer{};
  /// When it was given its final value, on the session's clock. Absent where it is the only answer
  /// of its page, or where only the time at which `ask` returned is known.
  std::optional<std::int64_t> given_ns{};
};
/// The answers to the questions of a page, in their order; none where an optional question is left empty.
using GivenAnswers = std::vector<GivenAnswer>;
/// The answer to a page with one question.
inline GivenAnswers only_answer(Answer answer) { return {{std::move(answer), {}}}; }

/// The result of asking the questions of a page.
struct Reply {
  std::variant<NoAnswer, FeelAgain, GivenAnswers> what{};
  /// When the answers were confirmed or the wish to feel again was made, on the session's clock: the
  /// time stamp of the key or button. Absent where only the time at which `ask` returned is known.
  std::optional<std::int64_t> answered_ns{};

  /// Null for any other reply.
  const GivenAnswers* answers() const noexcept { return std::get_if<GivenAnswers>(&what); }
  const FeelAgain* feel_again() const noexcept { return std::get_if<FeelAgain>(&what); }
  /// The answer to the only question of a page; null for any other reply.
  const Answer* answer() const noexcept {
    const GivenAnswers* const all = answers();
    return all == nullptr || all->size() != 1 ? nullptr : &all->front().answer;
  }
  /// The number that answers the only question of a page; nothing for any other reply.
  std::optional<double> number() const noexcept {
    const Answer* const given = answer();
    const auto* const of_number = given == nullptr ? nullptr : std::get_if<GivenNumber>(given);
    return of_number == nullptr ? std::nullopt : std::optional(of_number->number);
  }
};

/// A press or release of a device button, found in the servo's records.
struct ButtonChange {
  int button = 0;  ///< from 1
  bool down = false;
  std::int64_t time_ns = 0;  ///< of the tick, on the session's clock
};

/// The participant left: closed the terminal, or asked to stop.
class RespondentGone final : public PhrasedError {
  using PhrasedError::PhrasedError;
};

/// The participant's side of a session. Every call may take its time through `wait`.
class Respondent {
 public:
  virtual ~Respondent() = default;
  Respondent(const Respondent&) = delete;
  Respondent& operator=(const Respondent&) = delete;

  /// Shows instructions, breaks, thanks, and what the experimenter is to do before a trial; returns
  /// when they have been read.
  virtual void read(const std::string& text, double minimum_s, const Wait& wait) = 0;
  /// Announces that the surface can be felt now.
  virtual void announce(const Trial& trial, const PlannedPresentation& surface) = 0;
  /// Asks one page of questions of the trial (pages_of). `felt` are the features of the force of
  /// each surface, by position. `deadline_s` is the remaining time to answer, from now on.
  virtual Reply ask(const Trial& trial, std::span<const Question> page,
                    std::span<const ForceFeatures> felt, std::optional<double> deadline_s,
                    const Wait& wait) = 0;
  /// Gives feedback after a practice trial.
  virtual void tell(const std::string& text, const Wait& wait) = 0;
  /// Asks a question about the participant or the session; returns nothing where it was left empty.
  virtual std::optional<Answer> answer(const Question& question, const Wait& wait) = 0;
  /// When the last `answer` was given, as in Reply. Absent where only the time at which it returned
  /// is known.
  virtual std::optional<std::int64_t> answered_ns() const { return {}; }
  /// The source of the last answer: "keyboard", "virtual", "virtual_guess".
  virtual std::string source() const = 0;
  /// Called before each attempt; a virtual participant takes its random stream for the attempt from
  /// here.
  virtual void begin_attempt(int trial, int attempt) = 0;

  /// Polled while a surface is felt: whether the participant wants to continue. Before the minimum
  /// contact time of the protocol (`may_go`), such a request is refused.
  virtual bool wants_next(bool may_go) {
    static_cast<void>(may_go);
    return false;
  }
  /// The surface that the participant wished to feel was presented and not touched: this visit does not count, what was
  /// felt before stays valid, and the question is asked next. A virtual participant does not request the surface once
  /// more: its hand cannot reach it.
  virtual void visit_was_without_contact(int position) { static_cast<void>(position); }
  /// Polled in an attempt while neither a surface is felt nor the question is shown: the hand
  /// lifts, or waits for the next surface. Answers are refused.
  virtual void refuse_answers() {}
  /// Whether the participant can wear an eye mask: a participant at a window. Others are never
  /// asked to put one on.
  virtual bool wears_mask() const { return false; }
  /// Whether what the protocol requests of the experimenter is shown in the experimenter's own
  /// window and not to the participant.
  virtual bool leaves_prompts_to_experimenter() const { return false; }
  /// Asks for the eye mask to be put on or taken off; returns when that was confirmed.
  virtual void put_mask(bool on, const Wait& wait);
  /// Reports that the force is held at zero after a fault, and why. Does nothing where the
  /// experimenter has a window.
  virtual void hear_of_fault(const std::string& what) { static_cast<void>(what); }
  /// The request after a fault: none yet, clear the fault and resume the session, or end it.
  enum class AfterFault { nothing, go_on, end };
  /// Polled while the session waits in a fault; does not wait.
  virtual AfterFault after_fault() { return AfterFault::nothing; }
  /// Called while time passes in `wait`.
  virtual void button_changed(const ButtonChange& change) { static_cast<void>(change); }
  /// The events at the participant's side since the last call, for the store: keys with press and
  /// release, refusals, changes of an assignment.
  virtual std::vector<EventRow> take_events() { return {}; }

 protected:
  Respondent() = default;
};

}  // namespace asperity
