// Declares diagnostics of a protocol file: the problem, its location and the correction.

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

/// One problem. `line` and `column` count from 1 and are 0 if the file could not be read; `pointer` is the JSON pointer
/// of the location.
struct Diagnostic {
  std::string file{};
  int line = 1;
  int column = 1;
  std::string pointer{};
  Phrase message{};
};

/// `FILE:LINE:COLUMN: error: message (/json/pointer)`; `FILE: error: message` for a file that could not be read.
std::string text_of(const Diagnostic& diagnostic);

void append(std::vector<Diagnostic>& diagnostics, std::vector<Diagnostic> added);

/// Reports an invalid protocol with all problems found.
class ProtocolError final : public std::runtime_error {
 public:
  explicit ProtocolError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_{};
};

}  // namespace asperity
