// Implements the text of a diagnostic.

#include "protocols/file/diagnostic.h"

#include <iterator>
#include <utility>

namespace asperity {

std::string text_of(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line > 0) {
    text += ':' + std::to_string(diagnostic.line) + ':' + std::to_string(diagnostic.column);
  }
  text += ": error: " + diagnostic.message.english();
  if (!diagnostic.pointer.empty()) text += " (" + diagnostic.pointer + ")";
  return text;
}

void append(std::vector<Diagnostic>& diagnostics, std::vector<Diagnostic> added) {
  diagnostics.insert(diagnostics.end(), std::make_move_iterator(added.begin()),
                     std::make_move_iterator(added.end()));
}

namespace {

std::string all_of(const std::vector<Diagnostic>& diagnostics) {
  std::string text{};
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += text_of(diagnostic);
  }
  return text;
}

}  // namespace

ProtocolError::ProtocolError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(all_of(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace asperity
