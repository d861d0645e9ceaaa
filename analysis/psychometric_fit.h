// Psychometric functions fitted to counts: thresholds with their standard errors and intervals.

#pragma once

#include <optional>
#include <span>

#include "analysis/proportion.h"
#include "analysis/psychometric_likelihood.h"

namespace asperity {

/// Why data have a fit or not, in this order.
enum class PsychometricStatus {
  ok,
  no_data,
  all_correct,
  all_wrong,
  one_level,        ///< of a weibull, above 0
  separated,        ///< γ = λ = 0, and all wrong below, all right above: the slope has no maximum
  quasi_separated,  ///< the same but for one level with both
  not_increasing    ///< no increasing function is likelier than a constant one; see below
};

struct PsychometricJudgement {
  PsychometricStatus status = PsychometricStatus::ok;
  /// Where it is (quasi-)separated: between what the threshold lies.
  std::optional<ConfidenceInterval> bracket{};
};

/// Throws std::invalid_argument, as all of these do, for more hits than trials, levels that are not
/// finite (or negative for a weibull), and rates outside [0, 1).
PsychometricJudgement judge(std::span<const PsychometricBlock> blocks,
                            const PsychometricModel& model);

/// By maximum likelihood (`psychometric_maximum.h`).
struct PsychometricFit {
  PsychometricFunction function{};
  double log_likelihood = 0.0;
  double deviance = 0.0;
  double deviance_df = 0.0;
  std::optional<double> pearson{};     ///< absent where a fitted probability is 0 or 1
  std::optional<double> deviance_p{};  ///< of χ²; indicative only, for few trials per level
  bool beta_at_bound = false;
  bool lambda_at_bound = false;
  bool gamma_at_bound = false;

  double threshold = 0.0;  ///< x at the asked performance
  /// From the observed information of the parameters that are not at a bound; absent where β is, or
  /// where the information is singular.
  struct Precision {
    double alpha_se = 0.0;
    double beta_se = 0.0;
    double threshold_se = 0.0;
    ConfidenceInterval threshold{};  ///< ± z standard errors
  };
  std::optional<Precision> precision{};
  /// φ = X²/df, near 1 where hits vary as the binomial distribution says; absent where X² or its
  /// degrees of freedom are.
  std::optional<double> dispersion{};
  /// `precision` for hits that vary more than that: standard errors times √max(1, φ), and Student's
  /// limit with the degrees of freedom of φ instead of z [Finney 1971].
  ///
  /// [Finney 1971] Finney: Probit Analysis.
  std::optional<Precision> overdispersed{};
  /// Where λ is fixed: what λ between 0 and `greatest_lambda` gives instead. A wrong λ shifts α and
  /// the threshold, and no interval above allows for that.
  struct FreeLapses {
    double lambda = 0.0;
    double alpha = 0.0;
    double threshold = 0.0;
    double likelihood_ratio = 0.0;  ///< against the fixed λ
  };
  std::optional<FreeLapses> free_lapses{};
  /// The α that the likelihood ratio does not reject, the other parameters fitted again within their
  /// bounds. An end is absent where there is none: where one of the constant functions that the
  /// likelihood approaches as α → ±∞ (0 for a weibull) and β → 0 is not rejected either. Only with
  /// `precision`.
  std::optional<double> profile_low{};
  std::optional<double> profile_high{};
};

struct PsychometricQuestion {
  PsychometricModel model{};
  double performance = 0.5;  ///< of the threshold
  double confidence = 0.95;
};

/// Nothing where no function is likeliest because the data do not rise with the level
/// (`not_increasing`); `judge` cannot know that. Throws std::invalid_argument where `judge` is not ok.
std::optional<PsychometricFit> fit_psychometric(std::span<const PsychometricBlock> blocks,
                                                const PsychometricQuestion& question);

}  // namespace asperity
