// Declares the translation of a protocol's texts by a second file.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocols/file/diagnostic.h"

namespace asperity {

/// Whether the text is a JSON object whose "format" is that of translations, of any version.
bool is_translation(std::string_view text);

/// The same with the format of protocols.
bool is_protocol(std::string_view text);

/// A file of translated texts: {"format": "asperity.translation/1", "texts": {ADDRESS: {SOURCE: TRANSLATION, …}, …}}.
/// Addresses: translatable_texts.h. A SOURCE repeats the text that it translates, or its first words followed by "…".
struct TranslationFile {
  std::string_view text{};
  std::string name{};      ///< in its diagnostics
  std::string language{};  ///< as a BCP 47 tag
};

/// A protocol in another language.
struct TranslatedProtocol {
  /// The protocol with the translated texts and its language, on the same lines as before; everything else is unchanged
  /// byte for byte. Texts without a translation stay.
  std::string text{};
  /// Of the file of translations, in the order of its lines: wrong forms, entries without a text, entries whose text has
  /// changed, and texts for participants without an entry. With a problem the protocol is not in the other language.
  std::vector<Diagnostic> problems{};
  /// Texts that describe the protocol, without an entry.
  std::vector<Diagnostic> warnings{};
};

/// Errors: ProtocolError if the protocol, called `file`, is not JSON.
TranslatedProtocol translated(std::string_view protocol, const std::string& file,
                              const TranslationFile& translation);

}  // namespace asperity
