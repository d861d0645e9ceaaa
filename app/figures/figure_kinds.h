// Makes the figures of each kind from the findings of one analysis. Used only by figures_of.cpp.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/figures/finding_parts.h"
#include "app/findings/figure.h"
#include "app/findings/study/analysis_outcome.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// Proportions with intervals, a row each, and chance as a line; where it differs between rows, as
/// a mark in each. Single participants are shown behind means over participants.
std::vector<Figure> table_forests(const AnalysisOutcome& outcome);
Figure proportion_forest(const TidyInput& input, const FoundNumbers& found);
Figure selection_forest(const FoundNumbers& found);
Figure matching_forest(const FoundNumbers& found);
Figure recognition_forest(const FoundNumbers& found);
std::vector<Figure> seedpaper_forests(const FoundNumbers& found);

/// Items along a scale with intervals over participants, in descending order from the top.
struct ScaleChoice {
  std::string quantity{};
  /// Used where there is no finding of `quantity`, without its intervals, which treat all
  /// judgements as independent; may be empty.
  std::string otherwise{};
  std::string status{};  ///< of the fit
  Phrase title{};
};
Figure scale_figure(const std::string& name, const ScaleChoice& choice, const FoundNumbers& found);

/// Stimuli in rows, responses in columns: counts as numbers, proportions of a row as shades.
Figure confusion_figure(const FoundNumbers& found);
Figure confusion_figure(const NamedTable& table);

/// Which dissimilarities a dendrogram shows.
struct TreeChoice {
  std::string quantity{};  ///< the cophenetic dissimilarities
  Phrase title{};
  Phrase note{};
  Phrase axis{};
  Phrase none{};  ///< where there are no dissimilarities
};
TreeChoice tree_of_confusions();
TreeChoice rated_tree();

/// Similarity by confusions, as a tree and as a map.
Figure dendrogram(const FoundNumbers& found, const TreeChoice& choice = tree_of_confusions());
Figure similarity_map(const FoundNumbers& found);

/// Of rated dissimilarities: configuration, Shepard diagram, stress by dimensions, dendrogram and weights of the participants.
std::vector<Figure> perceptual_map_figures(const FoundNumbers& found);

/// Whether curves are named as those of probes, or by the names of the study's conditions.
enum class CurveNames { of_probes, alone };

/// Estimates by spacing on logarithmic axes, a curve per probe or condition, with the fitted
/// parabola and its peak. `unit`: of the spacings, where metres are displayed as millimetres; empty
/// where it is unknown.
Figure roughness_figure(const FoundNumbers& found, const std::string& unit, CurveNames names);

/// Estimates by stimulus: over the predictor on logarithmic axes with the power functions, a series per condition, or
/// without a predictor in rows. `predictor`: its name. `unit`: of it, if the name does not state it; lengths are drawn in
/// millimetres.
Figure stimulus_estimates_figure(const FoundNumbers& found, const Phrase& predictor,
                                 const std::string& unit);

/// Geometric means of response times by condition, with single participants behind them.
Figure response_times_figure(const FoundNumbers& found);
/// Medians of contact times by condition with their quartiles, from the findings of the exploration.
Figure contact_times_figure(const FoundNumbers& found);
/// Response times, and proportions correct, by range of trials: the mean over participants and a line for each.
Figure times_over_trials_figure(const FoundNumbers& found);
Figure correct_over_trials_figure(const FoundNumbers& found);

/// The means of two groups and their difference, a figure each. `axis`: contains a placeholder for
/// the confidence, in percent.
struct GroupChoice {
  std::string means{};  ///< the findings, by quantity
  std::string difference{};
  std::string pooled_difference{};  ///< empty: none
  Phrase axis{};
  bool are_shares = false;  ///< from 0 to 1
};
std::vector<Figure> group_figures(const GroupChoice& choice, const FoundNumbers& found);

/// Mean scores with intervals, a row per item.
Figure rating_figure(const FoundNumbers& found);

/// Mean ratings of the items on several scales, a row per scale and a line per item. `shown`: the
/// table of the ends and ranges of the scales; may be null.
Figure profile_figure(const NamedTable& ratings, const NamedTable* shown);

/// Scores of items as points and loadings of scales as arrows, on the first two components.
Figure biplot_figure(const FoundNumbers& found);

/// Means of the cells, the factor with the most levels along the axis and a line for each
/// combination of the others. `unit`: of levels that are numbers.
Figure interaction_figure(const TidyInput& input, const FoundNumbers& found,
                          const std::string& unit);

/// Power by sample size, a curve per plan; plans without a second size a row each.
Figure power_figure(const TidyInput& input, const FoundNumbers& found);

/// What the note of psychometric functions states.
struct FunctionsNote {
  enum class Intervals { none, delta, resamples, delta_and_resamples, repeated_procedure };
  enum class Thresholds { none, drawn };
  std::string percent_correct{};  ///< at the threshold; empty: points of subjective equality
  std::string confidence = "95";  ///< in percent
  Thresholds thresholds = Thresholds::drawn;
  Intervals intervals = Intervals::delta;  ///< of the drawn thresholds
};
/// Explains only the marks that are drawn.
Phrase note_on_functions(const FunctionsNote& note);

/// Proportions correct by level, the fitted function and its threshold. `unit`: of the levels. `levels`: the range of the
/// levels that the axis shows; those of the table without it.
Figure psychometric_figure(const TidyInput& input, const FoundNumbers& found,
                           const std::string& unit,
                           const std::optional<FigureSpan>& levels = std::nullopt);

/// Of a discrimination: the thresholds by condition, and the tracks and psychometric functions of each participant. None
/// without the tables of thresholds.
std::vector<Figure> threshold_figures(const AnalysisOutcome& outcome);

/// An ROC of a figure. `key`: of the findings of the family `roc`, without the rating.
struct RocCurve {
  std::string key{};
  Phrase name{};
};
/// Hits over false alarms of the ratings, the fitted normal model and its area; a series per curve.
Figure roc_figure(const FoundNumbers& found, std::span<const RocCurve> curves);
/// Of a discrimination with ratings of confidence: for every condition the ROCs of the levels, over all participants and
/// of each one.
std::vector<Figure> roc_figures(const AnalysisOutcome& outcome);

/// Responses to anchors by their place in a run, a figure for each row of the table of their change: the means, and a line
/// for each run of a participant. None without these tables.
std::vector<Figure> anchor_figures(const AnalysisOutcome& outcome);

/// The tracks of each participant, from the table of the trials of a discrimination.
std::vector<Figure> track_figures(const Table& table);

/// A trial of a track, whose level was chosen from the responses to the trials before it.
struct TrackTrial {
  std::string track{};
  double step = 0.0;  ///< its number in the track
  double level = 0.0;
  bool is_correct = false;
  bool is_unsure = false;    ///< the response "cannot tell"
  bool is_reversal = false;  ///< the level changes its direction after this trial
};
/// The note, which explains the symbol of the responses "cannot tell" if there are any.
Phrase with_note_on_unsure(const Phrase& note, std::span<const TrackTrial> trials);
/// Sets `is_reversal` from the levels; the trials are in order.
void mark_reversals(std::span<TrackTrial> of_one_track);
/// The trials with a response of the tables and the findings of the family `staircase`.
std::vector<TrackTrial> track_trials(const TidyInput& input, const FoundNumbers& found);
/// Levels over the trials of each track, in the order of the trials. `unit`: of the levels.
Figure tracks_figure(std::span<const TrackTrial> trials, const std::string& unit);

}  // namespace asperity
