// The participants of an export, under the labels and in the order in which it lists them.

#pragma once

#include <string>
#include <vector>

#include "app/exports/age_bands.h"
#include "app/exports/export_options.h"
#include "results_schema/study.h"

namespace asperity {

struct ExportedParticipant {
  ParticipantRow stored{};             ///< with the label of the study
  ParticipantRow listed{};             ///< with the label of the export
  std::vector<SessionRow> sessions{};  ///< in order, with the label of the export
};

/// By the label of the export. A public export is without those who withdrew; for `relabelled` the labels are drawn,
/// so that the order is random as well, and the labels have no gaps.
/// Errors: std::invalid_argument for `relabelled` without random bits.
std::vector<ExportedParticipant> exported_participants(const Study& study,
                                                       const ExportOptions& options);

/// "The sessions were run with Asperity 0.1.0, 0.2.0.": the versions of all sessions together, where the rows do not
/// state them; empty without a session.
std::string versions_text(const std::vector<ExportedParticipant>& participants);

/// Those of the participants with sessions: the data of the others cannot be mistaken for theirs.
AgeBands age_bands_of(const std::vector<ExportedParticipant>& participants);

}  // namespace asperity
