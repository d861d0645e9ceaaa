// What is said where there is no Qt, in the language of the windows.

#pragma once

#include <string>

#include <QtCore/QString>

#include "app/phrase.h"

namespace asperity {

/// What finds the words of the windows' language. Any thread.
Phrase::LookUp language_of_windows();

/// Any thread.
QString words_of(const Phrase& phrase);

/// What a study or a protocol says, as it is written there. Any thread.
inline QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

}  // namespace asperity
