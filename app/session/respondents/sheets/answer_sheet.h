// The answer to a trial's question while a participant composes it: one sheet per form of answer.

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <variant>

#include "app/session/respondents/participant_input.h"
#include "app/session/respondents/participant_scene.h"
#include "app/session/sound/sound.h"
#include "protocols/answers/trial_question.h"
#include "protocols/design/trial.h"

namespace asperity {

/// What an input did to a sheet.
struct SheetUnchanged {};  ///< it has no meaning there
struct SheetChanged {
  std::optional<Cue> cue{};  ///< sounds
  int number = 0;            ///< of that cue: option or surface, from 1
  /// A held button changed what the next confirmation does: until a moment after its release, what is
  /// pressed does not count.
  bool needs_new_reading = false;
};
struct SheetRefused {
  Saying saying{};  ///< why
};
/// The participant wishes to feel a surface again: the one that the input names, or the next.
struct WishToFeelAgain {};
/// The device's button points at that wish, and the next confirmation makes it.
struct PointedAtFeelingAgain {};
using SheetResult = std::variant<SheetUnchanged, SheetChanged, SheetRefused, WishToFeelAgain,
                                 PointedAtFeelingAgain, Answer>;

/// Keeps what has been chosen, assigned or typed until it is confirmed. It decides what an input means
/// for its form of answer; whether surfaces can be felt again is decided by its user, who may call
/// `forget_feeling_again`.
class AnswerSheet {
 public:
  virtual ~AnswerSheet() = default;
  AnswerSheet(const AnswerSheet&) = delete;
  AnswerSheet& operator=(const AnswerSheet&) = delete;

  virtual SheetResult take(const ParticipantInput& input) = 0;
  /// Puts the marks on a scene of this question: what is chosen, and whether it can be confirmed.
  virtual void mark(ParticipantScene& scene) const = 0;
  virtual void forget_feeling_again() {}

 protected:
  AnswerSheet() = default;
};

/// An empty sheet for the question of a trial.
std::unique_ptr<AnswerSheet> sheet_for(const Trial& trial);

}  // namespace asperity
