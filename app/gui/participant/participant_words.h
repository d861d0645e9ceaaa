// The program's own sentences to the participant, in the language of the windows.

#pragma once

#include <string>

#include <QtCore/QString>

#include "app/conductor/participant_scene.h"

namespace asperity {

/// What `saying` says; where it says nothing, `text` as the protocol wrote it.
QString words_of(const Saying& saying, const std::string& text);

}  // namespace asperity
