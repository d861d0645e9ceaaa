// Declares the search for words in what a form shows.

#pragma once

#include <string>
#include <vector>

#include <QtCore/QString>

#include "app/gui/editor/form/form_source.h"

namespace asperity {

/// The JSON pointers of the values with these words in their label or name, their meaning or what their field shows, in the
/// order of the pages. Folded and absent values are searched as well, in upper and lower case alike; no words are in no value.
std::vector<std::string> places_with(const FormSource& source, const QString& words);

}  // namespace asperity
