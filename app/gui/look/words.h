// What is said where there is no Qt, in the language of the windows.

#pragma once

#include <QtCore/QString>

#include "app/phrase.h"

namespace asperity {

/// What finds the words of the windows' language. Any thread.
Phrase::LookUp language_of_windows();

/// Any thread.
QString words_of(const Phrase& phrase);

}  // namespace asperity
