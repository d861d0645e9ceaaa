// Joins the thresholds of a discrimination, their means and the order effect.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/findings/methods/discrimination/thresholds/choices_by_place.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/tidy/quantity_name.h"

namespace asperity {

/// The tables, and the analyses of their findings.
inline constexpr const char* kThresholds = "thresholds";
inline constexpr const char* kMeanThresholds = "mean_thresholds";
inline constexpr const char* kComparedThresholds = "compared_thresholds";
inline constexpr const char* kPsychometric = "psychometric";
inline constexpr const char* kOrderEffect = "order";
/// The table of `PlacesOfPerson`; absent without a choice of three surfaces.
inline constexpr const char* kChoicesByPlace = "choices_by_place";
/// The table of the trials whose level a procedure chose, by track and step; absent without such trials.
inline constexpr const char* kTracks = "tracks";
/// The table of the responses "cannot tell", and the analysis of their rates; absent without any.
inline constexpr const char* kUnsure = "cannot_tell";
/// The table of the responses in catch trials; absent without any.
inline constexpr const char* kCatchTrials = "catch_trials";

/// The choices of the comparison by one participant, by the position of the comparison.
struct OrderOfPerson {
  std::uint32_t person = 0;
  ChoiceCount first{};   ///< the comparison was presented first
  ChoiceCount second{};  ///< the standard was
  std::size_t alternatives = 2;

  bool has_both() const { return first.trials > 0 && second.trials > 0; }
  double proportion_of(const ChoiceCount& count) const {
    return split_proportion(count, alternatives);
  }
  /// Proportion of choices of the comparison presented first, minus that of the comparison presented second. A response
  /// "cannot tell" counts as in `split_hits`.
  double difference() const { return proportion_of(first) - proportion_of(second); }
};

/// What is computed of the thresholds.
enum class ThresholdDetail {
  complete,
  estimates,  ///< without intervals and without means
  none,       ///< no function is fitted
};

/// The results of one task.
struct DiscriminationResults {
  DiscriminationResults(const GatheredAnswers& gathered, const DiscriminationStudy& of,
                        bool is_one_of_several, ThresholdDetail detail = ThresholdDetail::complete);

  const DiscriminationStudy& study;
  /// Of the task where there are several, otherwise empty.
  std::string name{};
  std::vector<std::string>
      conditions{};  ///< the names of the study's conditions, after that of the task
  /// Of the gathered people and the conditions with trials; keys: "PARTICIPANT|CONDITION".
  struct Function {
    std::uint32_t person = 0;
    std::size_t condition = 0;
    DiscriminationData data{};
  };
  std::vector<Function> functions{};
  DiscriminationFit fit{};
  /// By condition, analysis `mean_thresholds`, over the participants with such a number: mean.pse, mean.jnd,
  /// mean.jnd.dprime1, mean.jnd.posterior, mean.weber; and geomean.… of all but the PSE with intervals on the logarithmic
  /// scale, which contain no negative numbers. Without an interval where it is a bound, and a word in place of the number
  /// where it is none (`MeanOfThresholds`).
  std::vector<Finding> means{};
  /// Of two or more conditions, analysis `compared_thresholds`, over the participants with the threshold in every condition:
  /// geomean.Q by condition, Q being `quantity_of_threshold`, without intervals, because participants are left out; and of
  /// two conditions ratio.Q, key "SECOND|FIRST", the geometric mean of the participants' ratios, with a t-based interval on the
  /// logarithmic scale where every participant with trials in both has both.
  std::vector<Finding> compared{};
  /// Of the participants with trials; only of two alternatives.
  std::vector<OrderOfPerson> orders{};
  std::vector<PlacesOfPerson> places{};  ///< the same of a choice of three surfaces
  /// Analysis `order`: the mean of `OrderOfPerson::difference`, or `place_findings`.
  std::vector<Finding> order{};
  /// Analysis `cannot_tell`, of a study with such responses, with the keys of `functions`: `rate`, their proportion of the
  /// responses to these trials, with Wilson's interval.
  std::vector<Finding> unsure{};

  /// With trials in every condition: only within them can conditions be compared.
  std::size_t participants_in_all_conditions() const;

  /// What the test of the point of subjective equality of a condition is about: "amplitude", "amplitude (wood)".
  std::string about_equality(std::size_t condition) const;

  /// The name of a question: "threshold"; where there are several tasks, with that of this one: "threshold:amplitude".
  std::string name_of_question(const char* question) const {
    return name.empty() ? question : std::string(question) + ':' + name;
  }

  /// The quantity of the threshold that answers, tests and texts state.
  QuantityName quantity_of_threshold() const {
    return study.task.design->has_noise() ? QuantityName("jnd.dprime1") : "jnd";
  }
  /// Its geometric mean, and the ratio of those of two conditions.
  QuantityName mean_of_threshold() const {
    return study.task.design->has_noise() ? QuantityName("geomean.jnd.dprime1") : "geomean.jnd";
  }
  QuantityName ratio_of_threshold() const {
    return study.task.design->has_noise() ? QuantityName("ratio.jnd.dprime1") : "ratio.jnd";
  }

  /// "PSE", "JND", "detection threshold".
  std::string name_of_threshold() const {
    return study.task.is_detection() ? "detection threshold" : "JND";
  }
};

}  // namespace asperity
