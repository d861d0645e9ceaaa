// Checks the metadata that data archives require of a study: authors, license, ethics approval.

#pragma once

#include <optional>

#include "analysis/words/phrase.h"
#include "results_schema/rows.h"

namespace asperity {

/// "The study has no authors and no license, …", for an export; nothing where both are stored. The
/// remedy depends on the place: a command, or an entry of a menu.
std::optional<Phrase> missing_metadata(const StudyMetadata& metadata);

}  // namespace asperity
