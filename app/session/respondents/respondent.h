// Who answers: a person at a terminal, or a virtual participant.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "analysis/force_features.h"
#include "app/words/phrase.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"
#include "results_schema/rows.h"

namespace asperity {

/// Lets time go by while the participant thinks: seconds to wait. The servo ticks on meanwhile.
using Wait = std::function<void(double)>;

/// The time was over before an answer was given.
struct NoAnswer {};
/// The participant wishes to feel a surface again.
struct FeelAgain {
  int position = 0;
};

/// The result of asking the question of a trial.
struct Reply {
  std::variant<NoAnswer, FeelAgain, Answer> what{};
  /// When the answer was given or the wish to feel again was made, on the session's clock: the time
  /// stamp of the key or button itself. Absent where nothing better is known than the time at which `ask`
  /// returns.
  std::optional<std::int64_t> answered_ns{};

  /// Null where there is none.
  const Answer* answer() const noexcept { return std::get_if<Answer>(&what); }
  const FeelAgain* feel_again() const noexcept { return std::get_if<FeelAgain>(&what); }
  /// The number that was given; nothing of any other reply.
  std::optional<double> number() const noexcept {
    const Answer* const given = answer();
    const auto* const of_number = given == nullptr ? nullptr : std::get_if<GivenNumber>(given);
    return of_number == nullptr ? std::nullopt : std::optional(of_number->number);
  }
};

/// A button of the device went down or up, seen in the servo's records.
struct ButtonChange {
  int button = 0;  ///< from 1
  bool down = false;
  std::int64_t time_ns = 0;  ///< of the tick, on the session's clock
};

/// The person left: closed the terminal, asked to stop.
class RespondentGone final : public PhrasedError {
  using PhrasedError::PhrasedError;
};

/// The side of the participant. Every call may take its time through `wait`.
class Respondent {
 public:
  virtual ~Respondent() = default;
  Respondent(const Respondent&) = delete;
  Respondent& operator=(const Respondent&) = delete;

  /// Instructions, breaks, thanks, and what the experimenter is to do before a trial: returns when
  /// they have been read.
  virtual void read(const std::string& text, double minimum_s, const Wait& wait) = 0;
  /// The surface of this code can be felt now.
  virtual void announce(const Trial& trial, const PlannedPresentation& surface) = 0;
  /// `felt` are the features of what each surface felt like, by position. `deadline_s` is what is left
  /// to answer, from now on.
  virtual Reply ask(const Trial& trial, std::span<const ForceFeatures> felt,
                    std::optional<double> deadline_s, const Wait& wait) = 0;
  /// Feedback after a practice trial.
  virtual void tell(const std::string& text, const Wait& wait) = 0;
  /// Answers to a question about the person or the session, as text; empty where optional and left
  /// out.
  virtual std::string answer(const Question& question, const Wait& wait) = 0;
  /// When the last `answer` was given, as in Reply. Absent where nothing better is known than the time at
  /// which it returned.
  virtual std::optional<std::int64_t> answered_ns() const { return {}; }
  /// Where the last answer came from: "keyboard", "virtual", "virtual_guess".
  virtual std::string source() const = 0;
  /// Before each attempt; a virtual participant takes its random stream for it from here.
  virtual void begin_attempt(int trial, int attempt) = 0;

  /// Asked again and again while a surface is felt: whether the person has had enough of it. Until
  /// the shortest contact that the protocol asks for (`may_go`), a wish to go on is refused.
  virtual bool wants_next(bool may_go) {
    static_cast<void>(may_go);
    return false;
  }
  /// Asked again and again in an attempt while neither a surface is felt nor the question is there:
  /// the hand lifts, or waits for the next surface. What is pressed for an answer is refused.
  virtual void refuse_answers() {}
  /// There are eyes to be covered: a person at a window. Others are never asked to put on a mask.
  virtual bool wears_mask() const { return false; }
  /// What the protocol requests of the experimenter is not shown to the participant: it is asked at
  /// the experimenter's own window.
  virtual bool leaves_prompts_to_experimenter() const { return false; }
  /// The eye mask is to be put on or taken off; returns when that was confirmed.
  virtual void put_mask(bool on, const Wait& wait);
  /// The force is held at zero after a fault, for this reason. Does nothing where the experimenter has a window.
  virtual void hear_of_fault(const std::string& what) { static_cast<void>(what); }
  /// What is asked for then: nothing yet, that the fault is lifted and the session goes on, or its end.
  enum class AfterFault { nothing, go_on, end };
  /// Asked again and again while the session waits in a fault; does not wait.
  virtual AfterFault after_fault() { return AfterFault::nothing; }
  /// Called while time goes by in `wait`.
  virtual void button_changed(const ButtonChange& change) { static_cast<void>(change); }
  /// What happened at the participant's side since the last call, for the store: keys with press
  /// and release, refusals, changes of an assignment.
  virtual std::vector<EventRow> take_events() { return {}; }

 protected:
  Respondent() = default;
};

}  // namespace asperity
