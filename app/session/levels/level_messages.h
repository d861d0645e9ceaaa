// The lines that pass between a session and the program that chooses its levels (docs/formats/external.md).

#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "protocols/design/protocol.h"
#include "protocols/plan/level_tracks.h"
#include "results_schema/rows.h"

namespace asperity {

/// The version of the line protocol.
inline constexpr int kLevelProtocol = 1;

/// The first line: what the block presents, and the settings of the protocol.
std::string begin_line(const Protocol& protocol, const SessionRow& session,
                       const LevelRequest& request);
enum class TellKind { now, replayed };
/// The level is stated as one of the block where it differs from it by rounding only.
std::string tell_line(const TrackAnswer& answer, const External& settings, TellKind kind);
std::string ask_line(const LevelRequest& request);

/// The answers of a program to `ask`.
struct StatedLevel {
  double level = 0.0;
};
struct StatedEnd {};
struct StatedError {
  std::string text{};
};
struct NotUnderstood {};  ///< also a line with a key that occurs twice
using LevelReply = std::variant<StatedLevel, StatedEnd, StatedError, NotUnderstood>;
LevelReply reply_in(std::string_view line);

}  // namespace asperity
