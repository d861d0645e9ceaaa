// What the participant's keys mean.

#pragma once

#include <optional>

#include <QtCore/QString>

#include "app/conductor/participant_scene.h"

namespace asperity {

/// What a key or a click means to the present scene.
struct ParticipantAction {
  enum class What {
    choose,   ///< option `number` (from 1) of a question or form
    surface,  ///< surface `number` (from 1): to be felt, or the one that a picture is given to
    next,     ///< enough of this surface; feel again
    confirm,
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

/// What is pressed for an option of a form: "1" … "9", then "A" ….
QString key_of_form_option(int number);

}  // namespace asperity
