// The kinds of a study's events: what each states, until when it lasts, and what of it may be published.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// What is stored under one name in the table `event`. Exports, their codebook and the list in
/// docs/formats/study.md are made from this.
struct EventKind {
  std::string_view name{};
  /// What happened, and what the text and the data of such an event are.
  std::string_view meaning{};
  /// Tags of HED 8.3.0 (www.hedtags.org); see `hed_tags`.
  std::string_view hed{};
  /// The kinds of the events that end it. Empty: it happens at a moment.
  std::vector<std::string_view> ended_by{};
  /// The program or the protocol worded the text; otherwise a person or a driver did.
  bool text_is_public = false;
  /// The members of the data that identify neither a person nor a machine.
  std::vector<std::string_view> public_data{};
  /// The text is words, which are stored with their codes (app/words/coded_phrases.h); otherwise it is a name or a number.
  bool text_is_words = false;
};

/// In the order in which they are documented.
const std::vector<EventKind>& event_kinds();
/// Null for a kind that this version does not store: of its text and its data nothing is known.
const EventKind* event_kind(std::string_view name);
/// Whether it ends what is under way in a session, such as a pause.
bool ends_session(std::string_view kind) noexcept;

/// As one group with the name and the number of the event, the column `event`: HED takes rows of the same onset
/// together, and no two groups of them may be the same.
std::string hed_tags(const EventKind& kind);
/// The version of HED that `hed_tags` and the levels of protocols are written in.
inline constexpr const char* kHedVersion = "8.3.0";

}  // namespace asperity
