// Phrases that are stored by a code with arguments, so that a study can be shown in every language.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "app/words/phrase_registry.h"
#include "results_schema/rows.h"

namespace asperity {

/// The format of StoredWords::json and device profiles: typed text is a string, a coded phrase an
/// object.
nlohmann::ordered_json json_of(const Phrase& phrase);
/// For a code that this version does not have: the code, with its arguments.
Phrase phrase_from(const nlohmann::ordered_json& item);

StoredWords stored(const Phrase& phrase);
/// The program's words can be translated; typed text is unchanged.
Phrase phrase_of(const StoredWords& words);
/// Empty where nothing is stored.
Phrase phrase_of(const std::optional<StoredWords>& words);
/// The text of an event: words, or the names and data of its kind unchanged.
Phrase phrase_of(const EventRow& event);

EventRow event_row(std::int64_t time_ns, const std::string& kind, const Phrase& text,
                   const std::string& data_json = "null");

/// The codes of its reasons, in order: "force_limited; exploration_not_compliant". "typed"
/// represents typed text.
std::string codes_of(const StoredWords& words);
/// For publication: a reason that an experimenter chose may concern a participant, and is given as
/// "typed" as well.
std::string published_codes_of(const StoredWords& words);

}  // namespace asperity
