// Declares the replacement of the textures of a template by those of a study.

#pragma once

#include <optional>
#include <span>
#include <string>

#include "protocols/file/json_document.h"

namespace asperity {

/// A relief of a study.
struct OwnTexture {
  std::string name{};                 ///< in the protocol, [a-z][a-z0-9_]*
  std::string height_field{};         ///< relative to the study
  std::string picture{};              ///< empty: none
  std::optional<double> spacing_m{};  ///< of its elements
};

/// The protocol's text with these textures in place of its own, in their order and with all references: levels of factors, listed
/// trials, pictures. Of a protocol with more textures, the others are removed with the entries of lists that refer to them, and
/// a place outside of lists, such as an anchor, names a remaining one; of one with fewer, the last one is copied with the
/// entries of lists that name it. What belongs to the template's textures is left out: their true relief, recordings and measured
/// features, the description of the protocol, and the meanings of the factors that they are levels of. The spacing of a texture of the study is
/// stated where the template has one. Where fewer textures are left, blocks have no order that they cannot have, and no fewer trials
/// than a criterion needs.
///
/// The result can have problems, such as a list that is too short: the check states them. Errors: ProtocolError if a name cannot be
/// one, or if a texture has the name of a level that is none.
std::string with_textures(const JsonDocument& protocol, std::span<const OwnTexture> textures);

}  // namespace asperity
