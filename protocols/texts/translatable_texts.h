// Declares the list of the texts of a protocol that a translation replaces.

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/shapes/shape.h"

namespace asperity {

/// A text whose shape is translated, with its place in the protocol and its address in a translation.
///
/// The address is the JSON pointer with names in place of positions: an entry of a list has its "name" or "value" in the
/// address, an option that is a plain text has this text, and an entry without a name adds nothing. Texts of such
/// entries, as of the screens of the flow and the labels of a scale, share an address.
struct TranslatableText {
  std::string pointer{};  ///< of the text in the protocol
  std::string address{};  ///< "/questions/felt/options/yes/text", "/flow/screen"
  std::string text{};
  TextShape shape{};
};

/// All of them, in the order of the tables of keys. Values without the form of their key are left out.
std::vector<TranslatableText> translatable_texts(const nlohmann::json& protocol);

}  // namespace asperity
