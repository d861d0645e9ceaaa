// The program's own sentences to the participant, in the language of the protocol.

#pragma once

#include <string>

#include <QtCore/QString>

#include "app/session/respondents/participant_scene.h"

namespace asperity {

/// The sentence of `message` in this language (a BCP 47 tag); where it has none, `text` as the protocol wrote it.
QString words_of(const ParticipantMessage& message, const std::string& text,
                 const std::string& language);

}  // namespace asperity
