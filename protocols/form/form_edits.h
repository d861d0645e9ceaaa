// Declares the edits that a form makes of a protocol's text, each as the text after it.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/file/json_document.h"
#include "protocols/keys/names_in.h"
#include "protocols/shapes/key.h"

namespace asperity {

/// The text after an edit, and the place of the value that was edited, inserted or copied.
struct FormEdit {
  std::string text{};
  std::string pointer{};
};

// Outside of the touched entries the text stays as it is written (editing/edits.h). `protocol` has its own tree.
//
// Errors: ProtocolError with its place for what does not exist and for a name that is taken or that cannot be a name.

/// The value in place of the present one, or with its key in the order of the table if there is none. Objects around it that are
/// absent are written as well.
FormEdit with_value(const JsonDocument& protocol, const std::string& pointer,
                    std::string_view value);

/// With the simplest value (new_values.h) for a key that has none. Groups begin with a factor that can be theirs: without one,
/// also with this factor.
FormEdit with_new_value(const JsonDocument& protocol, const std::string& pointer,
                        const ProtocolKey& key);

/// Without these values, which can be entries of several containers.
FormEdit without(const JsonDocument& protocol, std::span<const std::string> pointers);

/// The entries of lists elsewhere that are about what these values declare, or values in them, and nothing else declares: its name,
/// listed trials with a level, the run of a block; of a texture also the levels that are this texture. Such an entry has no
/// meaning once the values are removed.
std::vector<std::string> entries_naming(const JsonDocument& protocol, const ProtocolNames& names,
                                        std::span<const std::string> pointers);

/// Without these values, the entries that are about them (entries_naming), and tests of the analysis that no block has any more.
FormEdit with_removed(const JsonDocument& protocol, std::vector<std::string> pointers);

/// With a new last entry of a list or a map. Without `key` it is a copy of the last one under another name, or the simplest value if
/// there is none; of a list of names, words or levels it is another one of them (new_entries.h). With `key` it is the simplest
/// value, in a map under this key, and in a list of objects of several kinds of this kind.
FormEdit with_entry(const JsonDocument& protocol, const std::string& container,
                    std::string_view key = {});

/// With a copy behind an entry; names that the entry itself declares get a number, and a name, a word or a level becomes another
/// one (new_entries.h).
FormEdit with_copy(const JsonDocument& protocol, const std::string& pointer);

/// With the entry at another position among its siblings.
FormEdit with_moved(const JsonDocument& protocol, const std::string& pointer, std::size_t index);

/// With another key of the member of a map, or another name that is the value, and with all references to it (rename_or_replace).
/// A value that declares nothing, or that is absent, is set.
enum class Named { by_key, by_value };
FormEdit with_name(const JsonDocument& protocol, const std::string& pointer, Named named,
                   std::string_view after);

/// With a new factor of two levels as the factor of the groups of participants. The place is that of the factor.
FormEdit with_factor_of_groups(const JsonDocument& protocol);

}  // namespace asperity
