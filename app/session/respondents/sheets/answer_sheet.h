// Stores the answers to a page of questions while they are composed: one sheet per form of answer.

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <variant>

#include "app/session/respondents/participant_input.h"
#include "app/session/respondents/participant_scene.h"
#include "app/session/respondents/respondent.h"
#include "app/session/sound/sound.h"
#include "protocols/answers/question.h"
#include "protocols/design/trial.h"

namespace asperity {

/// The effect of an input on a sheet.
struct SheetUnchanged {};  ///< it has no meaning for this sheet
struct SheetChanged {
  std::optional<Cue> cue{};  ///< played
  int number = 0;            ///< of the cue: option or surface, from 1
  /// A held button changed the effect of the next confirmation: inputs do not count until a moment
  /// after its release.
  bool needs_new_reading = false;
};
struct SheetRefused {
  ParticipantMessage message{};  ///< the reason
};
/// The participant requests to feel a surface again: the one that the input names, or the next.
struct WishToFeelAgain {};
/// The device's button selected that request, and the next confirmation makes it.
struct PointedAtFeelingAgain {};
using SheetResult = std::variant<SheetUnchanged, SheetChanged, SheetRefused, WishToFeelAgain,
                                 PointedAtFeelingAgain, GivenAnswers>;

/// Stores what has been chosen, assigned or typed until it is confirmed, and determines the effect
/// of an input for its form of answer. A confirmation without an answer leaves an optional question empty: GivenAnswers
/// without answers. Its user decides whether surfaces can be felt again, and may
/// call `forget_feeling_again`.
class AnswerSheet {
 public:
  virtual ~AnswerSheet() = default;
  AnswerSheet(const AnswerSheet&) = delete;
  AnswerSheet& operator=(const AnswerSheet&) = delete;

  virtual SheetResult take(const ParticipantInput& input) = 0;
  /// Marks what is chosen, and whether it can be confirmed, in a scene of this question.
  virtual void mark(ParticipantScene& scene) const = 0;
  virtual void forget_feeling_again() {}
  /// The position of the surface that is chosen or marked; nothing where the answer names no surface.
  virtual std::optional<int> chosen_surface() const { return {}; }

 protected:
  AnswerSheet() = default;
  /// The meaning of an input for every form of answer to a trial with so many surfaces: the wish to feel one again, or none.
  static SheetResult wish_of(const ParticipantInput& input, std::size_t surfaces);
};

/// An empty sheet for one of pages_of(trial), or for a question of the questionnaire with a trial without surfaces.
std::unique_ptr<AnswerSheet> sheet_for(const Trial& trial, std::span<const Question> page);

}  // namespace asperity
