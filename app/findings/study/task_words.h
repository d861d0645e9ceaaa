// Describes the task of a protocol as text.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"

namespace asperity {

/// In typographic quotation marks.
std::string quoted(const std::string& text);

/// The questions of the main blocks in quotation marks, each once.
std::vector<std::string> main_questions(const Protocol& protocol);

}  // namespace asperity
