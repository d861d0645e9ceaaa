// Declares the replacement of placeholders in the texts of a protocol, with the values that are known where each text is.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/texts/design_numbers.h"

namespace asperity {

/// Where a text is, which determines the values that it can state.
struct TextPlace {
  std::string pointer{};
  std::string text{};
  /// Of the consent, a screen or break of the flow, or a resumed session: it can state numbers of the session, and keeps its
  /// placeholders until it is read.
  bool is_of_session = false;
  const Protocol::Block* block = nullptr;  ///< of a text within a block; otherwise null
  std::vector<std::string> groups{};       ///< of a screen for some groups only; otherwise empty
};

/// The texts that participants read, except options that are stored as they are written. `root` is the JSON of the protocol.
std::vector<TextPlace> participant_texts(const nlohmann::json& root, const Protocol& protocol);

/// The values of a text from the design alone.
DesignValues values_of_design(const Protocol& protocol, const TextPlace& place);

/// `root` with these values in all texts but those of the session; nothing where no text has a placeholder.
std::optional<nlohmann::json> with_design_values(const nlohmann::json& root,
                                                 const Protocol& protocol);

/// A step of a plan with its texts as they are read in the session with these values (values_of_session).
PlanStep as_read(PlanStep step, const DesignValues& of_session, std::string_view language);
/// A plan (example_plan) with the texts of its steps as its participant reads them.
Plan as_read(const Protocol& protocol, Plan plan);

/// The statement of a valid protocol that a participant agrees to, with the values of every session.
std::string consent_as_read(const Protocol& protocol);

/// The texts of a protocol that are read in its sessions and have a placeholder; none of one that a program has made, without a source.
/// The consent is read before its session (consent_as_read).
std::vector<TextPlace> texts_with_placeholders(const Protocol& protocol);

/// Whether one of the texts states a number of the session.
bool states_session(const std::vector<TextPlace>& places);

/// A text as a participant reads it.
struct TextAsRead {
  std::string pointer{};
  std::string text{};
};

/// Texts of the protocol as read in the session with these values (values_of_session).
std::vector<TextAsRead> texts_as_read(const Protocol& protocol,
                                      const std::vector<TextPlace>& places,
                                      const DesignValues& of_session);

}  // namespace asperity
