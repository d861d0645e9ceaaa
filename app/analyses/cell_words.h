// The fixed words that stand in the cells of an analysis's tables, as people read them.

#pragma once

#include <string>

#include "app/phrase.h"

namespace asperity {

/// "right items of a go" of `right_items_per_go` in the column `measure`, "whole goes" of `whole` in
/// the column `test`. What has no other words, and every name that a study has given, stays.
Phrase words_of_cell(const std::string& column, const std::string& text);

}  // namespace asperity
