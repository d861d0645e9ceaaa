// What the participant's keys mean.

#pragma once

#include <optional>

#include <QtCore/QString>

#include "app/session/respondents/participant_scene.h"

namespace asperity {

/// What a key or a click means to the present scene.
struct ParticipantAction {
  enum class What {
    choose,   ///< option `number` (from 1) of a question or form
    surface,  ///< surface `number` (from 1): to be felt, or the one that a picture is given to
    next,     ///< enough of this surface; feel again
    confirm,
    mark,     ///< scale `number` (from 1), where it is pressed
    step,     ///< the mark of the current scale, `number` steps to the right
    select,   ///< the scale `number` places further on
    write,    ///< `text` into the number
    erase,    ///< the last digit of it
    turn_to,  ///< page `number` (from 1) of the words: of the picture, the session hears nothing
  };
  What what = What::confirm;
  int number = 0;
  QString text{};

  bool operator==(const ParticipantAction&) const = default;
};

/// What a key stands for, by the text that it types; nothing where the scene has no use for it.
std::optional<ParticipantAction> action_of_key(const ParticipantScene& scene, int key,
                                               const QString& text);

/// A number is typed here, of a trial or a form.
bool takes_typed_number(const ParticipantScene& scene);
/// It may be below 0.
bool may_be_negative(const ParticipantScene& scene);
/// What a key adds to a number although no number has it: "/", "x". It is seen where it was typed, and
/// said to be wrong (`is_no_number`), as what is left out of "1/2" would be another number.
std::optional<ParticipantAction> sign_amiss(const ParticipantScene& scene, const QString& text);
/// Whatever is typed after it: "1/2", "1.2.3", and more signs than a number has. "1e" is none yet.
bool is_no_number(const ParticipantScene& scene, const QString& typed);

/// What is pressed for an option of a form: "1" … "9", then "A" ….
QString key_of_form_option(int number);

}  // namespace asperity
