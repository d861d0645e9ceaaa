// The part of Conductor that stores the matches of roughness.

#include <nlohmann/json.hpp>

#include "app/session/conductor.h"

namespace asperity {

/// The matches of a resumed session; those that an interruption kept from being stored are stored now.
void Conductor::note_earlier_matches() {
  noted_matches_.clear();
  for (const EventRow& event : study_.events(session_.row.id)) {
    if (event.kind != "roughness_match") continue;
    const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
    if (!data.is_object()) continue;
    noted_matches_.insert({data.value("block", ""), data.value("stimulus", ""),
                           data.value("model", ""), data.value("texture", "")});
  }
  note_matches();
}

/// Stores the matches of roughness that the store lacks.
void Conductor::note_matches() {
  for (const auto& [block, matches] : session_.course->matches()) {
    for (const RoughnessMatch& match : matches) {
      if (!noted_matches_.insert({block, match.stimulus, match.model, match.texture}).second) {
        continue;
      }
      const nlohmann::ordered_json data{{"block", block},
                                        {"stimulus", match.stimulus},
                                        {"model", match.model},
                                        {"texture", match.texture},
                                        {"relative_amplitude", match.relative_amplitude},
                                        {"status", text_of(match.status)},
                                        {"answers", match.answers},
                                        {"reversals", match.reversals}};
      course_.event("roughness_match", Phrase(std::string(text_of(match.status))), data.dump());
    }
  }
}

}  // namespace asperity
