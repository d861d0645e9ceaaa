// Describes the task of a protocol as text.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocols/design/protocol.h"

namespace asperity {

/// In typographic quotation marks.
std::string quoted(const std::string& text);

/// The scales of the main blocks of the kind rating, or those that accompany the questions of another kind, with their
/// points: "5 scales with 7 points from −3 to 3", "one continuous scale from 0 to 100"; empty without a scale.
std::string scales_of_blocks(const Protocol& protocol, std::string_view kind);

/// The questions of the main blocks in quotation marks, each once.
std::vector<std::string> main_questions(const Protocol& protocol);

}  // namespace asperity
