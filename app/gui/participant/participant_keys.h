// What the participant's keys mean.

#pragma once

#include <optional>

#include <QtCore/QString>

#include "app/gui/participant/pages/participant_item.h"

class QKeyEvent;

namespace asperity {

/// With Control, Alt or Meta it is a command to a window, and no answer.
bool is_command_key(const QKeyEvent& event);

/// What a key types; on a keyboard whose row of digits types other signs (French), the digit that
/// stands on it.
QString sign_of_key(const ParticipantScene& scene, const QKeyEvent& event);

/// What a key stands for, by the sign that it types; nothing where the scene has no use for it. Where
/// a number is typed, a sign that no number has ("/", "x") is written as well: it is seen where it was
/// typed, and said to be wrong, as what is left out of "1/2" would be another number.
std::optional<ParticipantAction> action_of_key(const ParticipantScene& scene, int key,
                                               const QString& sign);

}  // namespace asperity
