// Declares the collections of the labels and other texts of keys that forms show.

#pragma once

#include <map>
#include <set>
#include <string_view>

namespace asperity {

/// The distinct texts of all keys of a protocol: labels, meanings (also of objects, entries and words) and computed
/// defaults. A meaning can name other keys in backticks, of which forms show the labels. The texts are English; windows
/// look up their translations in the context "Keys".
std::set<std::string_view> texts_of_keys();

/// The words that choices of keys offer; windows look up their names in the context "WordsOfKeys".
std::set<std::string_view> words_of_keys();

/// The sentences about keys that are not permitted where they are, as the tables state them; likewise translated.
std::set<std::string_view> problems_of_keys();

/// The labels of keys by their names; without the names that have different labels in different objects.
std::map<std::string_view, std::string_view> labels_of_keys();

}  // namespace asperity
