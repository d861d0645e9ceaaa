// Fits d′ = (x/α)^β per participant and condition; a Wald interval with limits more than 100-fold apart is omitted.

#include "app/findings/methods/discrimination/thresholds/detection_thresholds.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/methods/discrimination/thresholds/missing_threshold.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr double kConfidenceOfDetections = 0.95;
/// Wald's interval assumes that the log likelihood is quadratic over it. Where it is wider, the responses hardly determine the
/// threshold, and its ends are arbitrary.
constexpr double kGreatestRatioOfLimits = 100.0;

WhyNoThreshold why_no_detection(DetectionStatus status) {
  switch (status) {
    case DetectionStatus::ok:
      break;
    case DetectionStatus::one_difference:
      return {"one_level",
              phrase("MissingThreshold",
                     "one level differs from the standard, and a function requires two: see d′ in "
                     "the table of sensitivities")};
    case DetectionStatus::no_data:
      return {"no_data",
              phrase("MissingThreshold",
                     "there are no trials without a difference, or none with one: complete the "
                     "session")};
    case DetectionStatus::all_yes:
      return {"all_same_response",
              phrase("MissingThreshold",
                     "every response is the same: check that the question was understood")};
    case DetectionStatus::all_no:
      return {"all_same_response",
              phrase("MissingThreshold",
                     "every response is the same: check that the question was understood")};
    case DetectionStatus::separated:
      return {"separated",
              phrase("MissingThreshold",
                     "a step function fits perfectly: present levels between those on either side "
                     "of the step")};
    case DetectionStatus::not_increasing:
      return {"not_increasing",
              phrase("MissingThreshold",
                     "hits are not more frequent than false alarms, as if the responses were "
                     "guesses: check the responses in the practice before you present other "
                     "levels")};
  }
  return {"not_defined",
          phrase("MissingThreshold",
                 "no threshold is defined for these data: add trials at several levels")};
}

/// The thresholds of one function after another, with the reasons for missing ones.
class DetectionList final {
 public:
  DetectionList(const DiscriminationTask& task, DiscriminationFit& fit) : task_(task), fit_(fit) {}

  void add(const DiscriminationData& data) {
    const std::vector<PsychometricBlock> blocks = psychometric_blocks(task_, data.hits);
    n_ = 0;
    for (const PsychometricBlock& block : blocks) n_ += static_cast<std::size_t>(block.trials);
    thresholds_.number("standard", data.key, task_.standard(),
                       basis("value of the parameter in the standard", task_.varied.unit));
    functions_.word("fit.design", data.key, std::string(task_.design->id), "ok",
                    basis("the design of the task"));
    const DetectionFit found = fit_detection(blocks, {.task = *detection_task(*task_.design),
                                                      .lambda = kSymmetricLapseRate,
                                                      .confidence = kConfidenceOfDetections});
    if (found.status != DetectionStatus::ok) return none(data.key, why_no_detection(found.status));
    add_function(data.key, found);
    const double alpha = found.function.alpha;
    const double least = smallest_difference(blocks);
    if (alpha > blocks.back().x) return none(data.key, threshold_above_levels());
    if (alpha < least) return none(data.key, threshold_below_levels());
    Basis estimate = basis("difference with d′ = 1, maximum likelihood", task_.varied.unit);
    if (found.alpha && found.alpha->high > kGreatestRatioOfLimits * found.alpha->low) {
      estimate.method +=
          "; no interval, because the limits of the Wald interval would differ by a factor of more "
          "than 100: the responses hardly determine the threshold";
    } else if (found.alpha) {
      estimate.method += "; Wald interval of its logarithm";
      estimate.interval = found.alpha;
      estimate.confidence = kConfidenceOfDetections;
    }
    thresholds_.number("jnd.dprime1", data.key, alpha, estimate);
    if (task_.standard() == 0.0) return;
    const double standard = std::abs(task_.standard());
    Basis fraction = basis_in_standards(estimate, standard);
    fraction.method = "just-noticeable difference at d′ = 1 divided by the standard";
    thresholds_.number("weber", data.key, alpha / standard, fraction);
  }

  void finish() {
    fit_.functions = functions_.take();
    for (Finding& finding : fit_.functions) finding.analysis = "psychometric";
    fit_.thresholds = thresholds_.take();
    for (Finding& finding : fit_.thresholds) finding.analysis = "thresholds";
  }

 private:
  Basis basis(std::string method, const std::string& unit = {}) const {
    return {.n = n_, .method = std::move(method), .unit = unit.empty() ? "1" : unit};
  }

  static double smallest_difference(const std::vector<PsychometricBlock>& blocks) {
    const auto first = std::find_if(blocks.begin(), blocks.end(),
                                    [](const PsychometricBlock& block) { return block.x > 0.0; });
    return first == blocks.end() ? 0.0 : first->x;
  }

  void none(const FindingKey& key, const WhyNoThreshold& why) {
    thresholds_.word("jnd.dprime1", key, why.word, why.sentence.english(), basis(""));
    if (task_.standard() != 0.0) {
      thresholds_.word("weber", key, why.word, why.sentence.english(), basis(""));
    }
    if (std::find(fit_.reasons.begin(), fit_.reasons.end(), why.sentence) == fit_.reasons.end()) {
      fit_.reasons.push_back(why.sentence);
    }
  }

  void add_function(const FindingKey& key, const DetectionFit& found) {
    const std::string method = "maximum likelihood, d′ = (x/α)^β";
    functions_.number("fit.detection.alpha", key, found.function.alpha,
                      basis(method, task_.varied.unit));
    functions_.number("fit.detection.beta", key, found.function.beta, basis(method));
    functions_.number("fit.detection.criterion", key, found.function.criterion,
                      basis(method + "; in standard deviations of an impression"));
    functions_.truth("bound.beta", key, found.beta_at_bound,
                     basis("whether the slope is at one of its limits"));
    functions_.number("loglik", key, found.log_likelihood, basis("binomial coefficients included"));
    functions_.number("deviance", key, found.deviance, basis("against one proportion per level"));
    functions_.number("deviance.df", key, found.deviance_df,
                      basis("number of levels minus number of parameters"));
    functions_.number("deviance.p.chisq", key,
                      upper_tail(ChiSquaredStatistic{.value = std::max(0.0, found.deviance),
                                                     .df = found.deviance_df})
                          .value_or(kUndefined),
                      basis("χ² test of the deviance; indicative only"));
  }

  const DiscriminationTask& task_;
  DiscriminationFit& fit_;
  FindingList functions_{};
  FindingList thresholds_{};
  std::size_t n_ = 0;
};

}  // namespace

std::optional<DetectionTask> detection_task(const DiscriminationDesign& design) {
  if (!design.has_noise()) return std::nullopt;
  return design.surfaces() == 1 ? DetectionTask::yes_no : DetectionTask::same_different;
}

DiscriminationFit fit_detections(const DiscriminationTask& task,
                                 std::span<const DiscriminationData> data) {
  DiscriminationFit fit{};
  DetectionList list(task, fit);
  for (const DiscriminationData& one : data) list.add(one);
  list.finish();
  return fit;
}

std::optional<DetectionFunction> detection_function(const DiscriminationDesign& design,
                                                    const FoundNumbers& functions,
                                                    const FindingKey& key) {
  const auto task = detection_task(design);
  const auto alpha = functions.value("fit.detection.alpha", key);
  const auto beta = functions.value("fit.detection.beta", key);
  const auto criterion = functions.value("fit.detection.criterion", key);
  if (!task || !alpha || !beta || !criterion) return std::nullopt;
  return DetectionFunction{.task = *task,
                           .alpha = *alpha,
                           .beta = *beta,
                           .criterion = *criterion,
                           .lambda = kSymmetricLapseRate};
}

}  // namespace asperity
