// The program that an experimenter has chosen to state the levels of a session.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Given on the command line or chosen in the window; no file names one, so that opening a study or a protocol of
/// another laboratory starts nothing.
struct ExternalProgram {
  std::filesystem::path file{};
  std::vector<std::string> arguments{};

  /// "staircase.py"
  std::string name() const { return file.filename().string(); }
};

/// The blocks whose levels a program states, in the order of their names.
std::vector<std::string> blocks_of_external_program(const Protocol& protocol);

/// Why a session cannot take its levels from this program: the protocol needs one and there is none, the protocol has no
/// use for one, the file is missing or cannot be executed. Nothing if it can.
std::optional<Phrase> complaint_about_program(const Protocol& protocol,
                                              const std::optional<ExternalProgram>& program);

/// Errors: PhrasedError with this complaint, and as `provenance_json`.
void require_program(const Protocol& protocol, const std::optional<ExternalProgram>& program);

/// Name, arguments and SHA-256 of the file, and of every argument that is a file: the data of `external_program`. Determined
/// at each start, because a program that failed can be corrected before it is started again. Errors: PhrasedError that
/// names the file that cannot be read.
std::string provenance_json(const ExternalProgram& program);

}  // namespace asperity
