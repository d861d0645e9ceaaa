// Declares the collection of the texts of keys that forms show.

#pragma once

#include <set>
#include <string_view>

namespace asperity {

/// The distinct texts of all keys of a protocol: labels, meanings (also of objects, entries and words) and computed
/// defaults. They are English; windows look up their translations in the context "Keys".
std::set<std::string_view> texts_of_keys();

}  // namespace asperity
