// What was made of a study and left its folder: exports, reports, copies.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/words/phrase.h"
#include "results_schema/study.h"

namespace asperity {

/// Stores in the study that `path` was made of it, so that it can be found again when a participant withdraws. To be
/// called with the output complete. Returns why it is not stored, where it is not: the study can only be read here, or
/// is of an older version, which would have to be changed for it.
std::optional<Phrase> record_output(const Study& study, OutputKind kind,
                                    const std::filesystem::path& path);

/// "public export": what it is, where it is listed.
Phrase kind_words(OutputKind kind);

/// Of a participant: what the study knows of that may hold their data.
struct OutputsOfParticipant {
  std::vector<OutputRow> recorded{};
  /// Where they took part before outputs were recorded: since when they are, UTC. Earlier ones are unknown.
  std::optional<std::string> unknown_before_utc{};
};
/// To be read before their rows are deleted: of a participant who took part in person, what was made since they were
/// added. A simulated participant has no date; of those, what holds the label or cannot be looked into now.
/// Errors: ResultsError for a label that is not there.
OutputsOfParticipant outputs_of_participant(const Study& study, const std::string& label);

}  // namespace asperity
