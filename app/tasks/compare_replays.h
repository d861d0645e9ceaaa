// Renders every recorded hand of a study again, and compares the forces with the recorded ones.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/signals/force_difference.h"
#include "app/plugins/plugin_builds.h"
#include "app/records/other_model.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// One recorded presentation.
struct ComparedPresentation {
  std::string participant{};
  int session = 0;
  int trial = 0;
  int attempt = 0;
  int surface = 0;  ///< its position in the trial, from 1
  std::string item{};
  std::string recorded_with{};  ///< version and commit of the program that ran the session
  std::string recorded_model{};
  std::string recorded_model_version{};
  std::string compared_model{};
  std::string compared_model_version{};
  ForceDifference forces{};
  /// Ticks left out because the recorded or the compared force is not a finite number.
  std::size_t ticks_not_finite = 0;
};

struct ReplayComparison {
  std::vector<ComparedPresentation> presentations{};  ///< in the order of an export
  ForceDifference pooled{};                           ///< the sum of all
  std::size_t attempts_without_recording = 0;
  std::size_t of_other_kind = 0;  ///< presentations left out: see feel_alike
};

struct ReplayComparisonOrder {
  /// Loaded force models: where there is no `other`, each surface is rendered again with the model of its id among them,
  /// in any version and build, with the recorded parameters.
  ModelBuilds builds;
  OtherModel* other = nullptr;
  int jobs = 1;
};

/// Compares the force that the renderer returned in each tick, before ramp and limits, as the recording stores it. The
/// recorded and the compared force are those of the same motion: the hand does not react to the other force. A stretch
/// of ticks ends where no surface was rendered and after a pause of more than kLift_s, and is transformed alone. Sessions of participants who
/// withdrew are left out.
///
/// The result does not depend on `jobs`. Nothing after a stop request. `progress` receives fractions, from any thread.
///
/// Errors: std::runtime_error or ResultsError that names the attempt and what is missing; the first one in the order of
/// the presentations.
std::optional<ReplayComparison> compare_replays(const Study& study,
                                                const ReplayComparisonOrder& order,
                                                const std::stop_token& stop,
                                                const std::function<void(double)>& progress);

/// A row per presentation; the columns are in docs/command-line.md.
Table table_of(const ReplayComparison& comparison);

/// "8 to 12.5 Hz"
std::string critical_band_name(std::size_t band);

}  // namespace asperity
