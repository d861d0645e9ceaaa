// The columns of the tables of discriminations, and the quantities of their thresholds.

#pragma once

#include <array>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/result_table.h"
#include "app/findings/tidy/quantity_name.h"

namespace asperity {

/// The level of the comparison, and what a task varies; levels, differences from the standard and thresholds have its unit.
inline const ResultColumn kLevelColumn{.id = "level", .heading = phrase("AnalysisWords", "level")};
inline const ResultColumn kParameterColumn{.id = "parameter", .is_for_files = true};
inline const ResultColumn kUnitOfLevels = for_files(columns::kUnit);

inline const ResultColumn kPseColumn{.id = "pse", .heading = phrase("AnalysisWords", "PSE")};
inline const ResultColumn kJndColumn{.id = "jnd", .heading = phrase("AnalysisWords", "JND")};
inline const ResultColumn kJndDprime1Column{.id = "jnd_dprime1",
                                            .heading = phrase("AnalysisWords", "JND at d′ = 1")};
inline const ResultColumn kJndPosteriorColumn{
    .id = "jnd_posterior", .heading = phrase("AnalysisWords", "JND, posterior mean")};
inline const ResultColumn kWeberColumn{.id = "weber",
                                       .heading = phrase("AnalysisWords", "Weber fraction")};
inline const ResultColumn kGeometricMean{.id = "geometric_mean",
                                         .heading = phrase("AnalysisWords", "geometric mean")};

// Of the responses by level, and of the trials of tracks.
inline const ResultColumn kUnsureColumn{
    .id = "unsure", .heading = phrase("AnalysisWords", "responses “cannot tell”")};
inline const ResultColumn kTrackColumn{.id = "track", .heading = phrase("AnalysisWords", "track")};
inline const ResultColumn kStepColumn{.id = "step",
                                      .heading = phrase("AnalysisWords", "trial of the track")};
inline const ResultColumn kHitColumn{.id = "hit", .heading = phrase("AnalysisWords", "hit")};
inline const ResultColumn kSignalTrials{.id = "signal_trials",
                                        .heading = phrase("AnalysisWords", "trials with a signal")};
inline const ResultColumn kNoiseTrials{
    .id = "noise_trials", .heading = phrase("AnalysisWords", "trials without a signal")};
/// Of the catch trials.
inline const ResultColumn kCatchTypeColumn{
    .id = "type", .heading = phrase("AnalysisWords", "type"), .words = words_of_catch_type};

/// A threshold of a participant: the quantity of its finding, its column, and the quantities of its arithmetic and its geometric
/// mean. A point of subjective equality has no geometric mean: it may have any sign.
struct ThresholdColumn {
  QuantityName quantity{};
  ResultColumn column{};
  QuantityName mean{};
  QuantityName geometric_mean{};  ///< empty: none
  bool has_unit_of_levels = true;
  /// Its interval.
  ResultColumn interval{};
};
inline const std::array kThresholdColumns{
    ThresholdColumn{"pse", kPseColumn, "mean.pse", "", true, interval_of(kPseColumn)},
    ThresholdColumn{"jnd", kJndColumn, "mean.jnd", "geomean.jnd", true, interval_of(kJndColumn)},
    ThresholdColumn{"jnd.dprime1", kJndDprime1Column, "mean.jnd.dprime1", "geomean.jnd.dprime1",
                    true, interval_of(kJndDprime1Column)},
    ThresholdColumn{
        "jnd.posterior", kJndPosteriorColumn, "mean.jnd.posterior", "geomean.jnd.posterior", true,
        interval_of(kJndPosteriorColumn, phrase("AnalysisWords", "JND, posterior, 95 % CrI"))},
    ThresholdColumn{"weber", kWeberColumn, "mean.weber", "geomean.weber", false,
                    interval_of(kWeberColumn)}};

}  // namespace asperity
