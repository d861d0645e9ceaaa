// The kinds of a study's events: meaning, end, and which of their contents may be published.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Describes the events stored under one name in the table `event`. Exports, their codebook and the
/// list in docs/formats/study.md are made from this.
struct EventKind {
  std::string_view name{};
  /// What happened, and what the text and the data of such an event contain.
  std::string_view meaning{};
  /// Tags of HED 8.3.0 (www.hedtags.org); see `hed_tags`.
  std::string_view hed{};
  /// The kinds of the events that end it. Empty: the event is instantaneous.
  std::vector<std::string_view> ended_by{};
  /// The text was worded by the program or the protocol; otherwise by a person or a driver.
  bool text_is_public = false;
  /// The members of the data that do not identify a person or a machine.
  std::vector<std::string_view> public_data{};
  /// Those of them that bound the time of the session, such as the version of a program.
  std::vector<std::string_view> dating_data{};
  /// The text consists of words, which are stored with their codes (app/words/coded_phrases.h);
  /// otherwise it is a name or a number.
  bool text_is_words = false;
};

/// The kinds of the events of a program that states levels.
inline constexpr const char* kExternalProgram = "external_program";
inline constexpr const char* kExternalLevel = "external_level";
inline constexpr const char* kExternalFailure = "external_program_failed";

/// In the order of the documentation.
const std::vector<EventKind>& event_kinds();
/// Null for a kind that this version does not store: its text and its data have no known meaning.
const EventKind* event_kind(std::string_view name);
/// Whether it ends all open events of a session, such as a pause.
bool ends_session(std::string_view kind) noexcept;

/// The tags as one group with the name and the number of the event, the column `event`: HED
/// combines rows of the same onset, and no two groups of them may be equal.
std::string hed_tags(const EventKind& kind);
/// The version of HED used in `hed_tags` and the levels of protocols.
inline constexpr const char* kHedVersion = "8.3.0";

}  // namespace asperity
