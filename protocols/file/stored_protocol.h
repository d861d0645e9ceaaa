// Declares the lenient reading of a stored protocol.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/keys/valid_part.h"

namespace asperity {

/// What can be read of a stored protocol. A study keeps the protocols of all its sessions, including those of other
/// versions of the program, which `read_protocol` may reject.
struct StoredProtocol {
  /// Parts that do not have the form of this version are absent; absent keys have their defaults. Blocks are completed as
  /// those of a file (complete_block), but for units and levels of models. The design of a block is null if this version
  /// does not know it.
  Protocol protocol{};
  std::vector<FormProblem> unread{};  ///< the parts that are absent for this reason
  /// By block: the factors whose levels determine its surfaces, each once, by name.
  std::map<std::string, std::vector<std::string>, std::less<>> surface_factors{};
  /// Of a selection whose alternatives differ only in the level of one parameter: the parameter's name.
  std::optional<std::string> compared_parameter{};

  /// What the participant is to see and hear; absent where another version states what this one does not know.
  struct Senses {
    std::optional<Vision> vision{};
    std::optional<Protocol::Noise> noise{};  ///< that masks the device
  };
  Senses senses() const;
};

/// Accepts any text; of one that is not JSON, all parts are absent.
StoredProtocol stored_protocol(const std::string& source);

/// The canonical text of a protocol without its language and texts: those for participants (consent,
/// screens, breaks, wording of questions and options) and those that describe the protocol (title, description,
/// meanings, notes). Protocols with equal results ask the same questions in the same plan. For a text that is not JSON,
/// the text itself.
std::string without_texts(const std::string& source);

/// The language that the source states; "en" if it states none.
std::string language_of(const std::string& source);

/// The number of distinct protocols among the files, which contain no text twice. Files that differ in language and
/// texts only count as one protocol in several languages; two such files in the same language count as two, because the
/// texts for participants are part of the experiment.
std::size_t count_protocols(const std::vector<std::string>& sources);

}  // namespace asperity
