// Phrases that are stored by a code with arguments, so that a study can be shown in every language.

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/words/phrase.h"
#include "results_schema/rows.h"

namespace asperity {

/// Every phrase that has a code, by its code. A code stays for ever; its words may change.
const std::map<std::string, Phrase, std::less<>>& coded_phrases();

/// Both, with a semicolon between; the second where the first is empty.
Phrase with_semicolon(const Phrase& first, const Phrase& second);
/// Both, with a comma between; the second where the first is empty.
Phrase with_comma(const Phrase& first, const Phrase& second);

/// As StoredWords::json and device profiles have it: typed text is a string, a coded phrase an object.
nlohmann::ordered_json json_of(const Phrase& phrase);
/// Of a code that this version does not know: the code, with its arguments.
Phrase phrase_from(const nlohmann::ordered_json& item);

StoredWords stored(const Phrase& phrase);
/// The program's own words can be translated; what was typed stays as it was.
Phrase phrase_of(const StoredWords& words);
/// Empty where nothing is stored.
Phrase phrase_of(const std::optional<StoredWords>& words);
/// The text of an event: words, or the names and data of its kind as they are.
Phrase phrase_of(const EventRow& event);

EventRow event_row(std::int64_t time_ns, const std::string& kind, const Phrase& text,
                   const std::string& data_json = "null");

/// The codes of the reasons in it, one after the other: "force_limited; exploration_not_compliant". "typed" stands for
/// what was typed.
std::string codes_of(const StoredWords& words);
/// For the public: what an experimenter chose may be about a person, and is "typed" as well.
std::string published_codes_of(const StoredWords& words);

}  // namespace asperity
