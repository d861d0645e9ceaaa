// Copies a protocol of the library into a study, as a starting point.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/tasks/check_protocol.h"
#include "protocols/file/library_protocols.h"
#include "protocols/form/own_textures.h"

namespace asperity {

/// The textures that a protocol from the library has in a study.
struct TemplateTextures {
  enum class From {
    files_of_its_names,  ///< of the study, if it has them
    study,               ///< `own`
    demonstration,       ///< its own, which are computed and written into the study
  };
  From from = From::files_of_its_names;
  std::vector<OwnTexture> own{};
};

/// A protocol of the library, and what becomes of it in a study.
struct TemplateChoice {
  std::string name{};  ///< in the library
  std::string
      language{};       ///< of its texts (BCP 47); empty, or not in the library: the protocol's own
  std::string title{};  ///< empty: that of the library
  TemplateTextures textures{};
};

/// Writes the library's protocol with its texts in one language into the study's `protocols/` and returns its file. Where the
/// study has a file of that name, also that of a translation, the new one, and the protocol in it, is named NAME_2, NAME_3, …, so
/// that sessions of the two are not mixed up. A texture of the demonstration, of whose files the study has others under the same
/// names, is written as NAME_2, NAME_3, …: no file of the study is used because of its name.
///
/// Errors: std::invalid_argument for a name that is not in the library; ProtocolError for own textures without a permitted name;
/// ResultsError when a file cannot be written.
std::filesystem::path protocol_from_template(const std::filesystem::path& study,
                                             const TemplateChoice& choice);

/// The text that the protocol's file gets, without the names that files of the demonstration have in the study. With own textures,
/// force models that need other files than reliefs, such as recordings, are left out of comparisons, and breaks that fewer
/// trials do not reach; and an estimation by spacing is one by stimuli ("factor" in place of "spacing", with the tests of that way) if
/// one of them states no spacing, or all fewer than three different ones.
///
/// Errors: as `protocol_from_template`, for the name and for own textures.
std::string text_from_template(const TemplateChoice& choice);

/// The text of a new protocol, and its check.
struct CheckedTemplate {
  std::string text{};
  ProtocolCheck check{};
};

/// This text with its check, before anything is written. `kept`: as for `check_protocol_text`. Errors: as `text_from_template`.
CheckedTemplate check_of_template(const std::filesystem::path& study, const TemplateChoice& choice,
                                  const ModelRegistry& models, KeptHeightFields* kept = nullptr);

/// The protocol's text with its texts in the language, if the library has it, and otherwise unchanged.
std::string text_in_language(const LibraryProtocol& protocol, const std::string& language);

/// Writes the library's protocol and its translations, byte for byte. Errors: ResultsError when the study has a file of these
/// names, and when one cannot be written.
void write_library_protocol(const std::filesystem::path& study, const LibraryProtocol& protocol);

/// The textures of a protocol of the library.
struct TexturesOfTemplate {
  std::vector<std::string> names{};
  bool have_pictures = false;         ///< some of them
  bool are_of_demonstration = false;  ///< all of their files
};
TexturesOfTemplate textures_of(const LibraryProtocol& protocol);

}  // namespace asperity
