// What is said where there is no Qt, in the language of the windows.

#pragma once

#include <QtCore/QString>

#include "app/phrase.h"

namespace asperity {

/// Any thread.
QString words_of(const Phrase& phrase);

}  // namespace asperity
