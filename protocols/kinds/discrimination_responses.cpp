// Draws impressions of the surfaces about a psychometric function, and decides by the design.

#include "protocols/kinds/discrimination_responses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string_view>

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr const char* kThreshold = "threshold";
constexpr const char* kShift = "shift";
constexpr const char* kOrder = "order";
constexpr const char* kCriterion = "criterion";

bool is_performance(const TabulatedQuestion& asked) {
  return asked.question.judgement() == DiscriminationJudgement::performance;
}

bool is_below_the_standard(const TabulatedQuestion& asked) {
  return asked.values.front() < *asked.block.vary->standard;
}

/// A threshold within the presented differences: the geometric mean of the smallest and the greatest one.
double usual_threshold(const TabulatedQuestion& asked) {
  const double standard = *asked.block.vary->standard;
  std::optional<double> smallest{};
  double greatest = 0.0;
  for (const double value : asked.values) {
    const double difference = std::abs(value - standard);
    greatest = std::max(greatest, difference);
    if (difference > 0.0) smallest = std::min(smallest.value_or(difference), difference);
  }
  return std::sqrt(smallest.value_or(greatest) * greatest);
}

/// Whether the responses match models in roughness for a later block, so that they are not analysed.
bool is_matched_by_others(const TabulatedQuestion& asked) {
  const auto& blocks = asked.protocol.blocks;
  return std::any_of(blocks.begin(), blocks.end(), [&asked](const auto& each) {
    return each.second.equal_roughness &&
           each.second.equal_roughness->matched_in == asked.block.name;
  });
}

/// What the tests of a block concern: nothing of a block that is not analysed. Without a declared family, that of designs
/// in which no surface is chosen has the conditions.
std::vector<std::string> family_of_block(const TabulatedQuestion& asked) {
  if (is_matched_by_others(asked)) return {};
  const std::vector<std::string>& declared = asked.protocol.analysis.family;
  const bool is_declared =
      std::any_of(asked.family.begin(), asked.family.end(), [&declared](const std::string& name) {
        return std::find(declared.begin(), declared.end(), name) != declared.end();
      });
  if (!is_declared && asked.block.design()->has_noise()) return {"conditions"};
  return asked.family;
}

std::string ratio_of(const std::string& factor) { return factor + ".ratio"; }

void add_thresholds(const TabulatedQuestion& asked, ParameterList& list) {
  const std::string& unit = asked.block.vary->unit;
  const double usual = usual_threshold(asked);
  list.assumed(
      {.name = kThreshold,
       .range = ParameterRange::positive,
       .unit = unit.empty() ? "1" : unit,
       .meaning = phrase("Responses",
                         "difference from the standard with d′ = 1 of the median participant"),
       .value = usual});
  list.assumed({.name = "threshold_sd",
                .range = ParameterRange::not_negative,
                .meaning = phrase("Responses",
                                  "SD over participants of the natural logarithm of the threshold"),
                .value = 0.4});
  list.varies_within_groups("threshold_sd");
  list.assumed({.name = "slope",
                .range = ParameterRange::positive,
                .meaning = phrase("Responses", "exponent with which d′ grows with the difference"),
                .value = 1.0});
  const auto* const groups = groups_in(asked);
  for (const auto& [factor, levels] : asked.factors) {
    ResponseParameter ratio{
        .name = ratio_of(factor),
        .range = ParameterRange::positive,
        .unit = "ratio",
        .meaning = phrase("Responses", "threshold at %1 divided by that at %2")
                       .with(quoted_name(levels.back()), quoted_name(levels.front())),
        .null_value = 1.0};
    if (groups != nullptr && groups->first == factor) {
      list.effect_of_groups(std::move(ratio));
      continue;
    }
    list.effect({.effect = std::move(ratio),
                 .tests = {"conditions"},
                 .sd_meaning = phrase(
                     "Responses", "SD over participants of the natural logarithm of this ratio"),
                 .usual_sd = 0.2});
  }
  if (is_performance(asked)) return;
  list.effect({.effect = {.name = kShift,
                          .unit = unit.empty() ? "1" : unit,
                          .meaning = phrase("Responses",
                                            "point of subjective equality minus the standard")},
               .tests = {"point_of_subjective_equality"},
               .sd_unit = unit.empty() ? "1" : unit,
               .sd_meaning = phrase("Responses", "SD over participants of this difference"),
               .usual_sd = 0.5 * usual});
}

void add_decision(const TabulatedQuestion& asked, ParameterList& list) {
  const DiscriminationDesign& design = *asked.block.design();
  if (!design.has_noise()) {
    list.effect(
        {.effect = {.name = kOrder,
                    .unit = "d′",
                    .meaning = phrase("Responses",
                                      "advantage of the first surface: what is added to its "
                                      "impression before the choice")},
         .tests = {"order"},
         .sd_unit = "d′",
         .sd_meaning = phrase("Responses", "SD over participants of this order effect"),
         .usual_sd = 0.3});
  } else {
    list.assumed(
        {.name = kCriterion,
         .unit = "d′",
         .meaning = design.surfaces() == 1
                        ? phrase("Responses", "impression above which the response is \"yes\"")
                        : phrase("Responses",
                                 "difference of two impressions from which on the response is "
                                 "\"different\""),
         .value = design.surfaces() == 1 ? 0.5 : 1.5});
    list.assumed({.name = "criterion_sd",
                  .range = ParameterRange::not_negative,
                  .unit = "d′",
                  .meaning = phrase("Responses", "SD over participants of the criterion"),
                  .value = 0.3});
  }
  if (asked.question.allow_cannot_tell) {
    list.assumed(
        {.name = "unsure_within",
         .range = ParameterRange::not_negative,
         .unit = "d′",
         .meaning = phrase("Responses",
                           "difference of two impressions below which the response is \"cannot "
                           "tell\""),
         .value = 0.3});
  }
  list.lapse();
}

std::vector<ResponseParameter> parameters_of_discrimination(const TabulatedQuestion& of) {
  TabulatedQuestion asked = of;
  asked.family = family_of_block(of);
  ParameterList list(asked);
  add_thresholds(asked, list);
  add_decision(asked, list);
  return list.take();
}

double threshold_in(const TabulatedTrial& trial) {
  Random own = trial.of_participant.split(kThreshold);
  double log_threshold =
      std::log(trial.values.at(kThreshold)) + trial.values.at("threshold_sd") * own.normal();
  const auto* const groups = groups_in(trial.asked);
  for (const auto& [factor, levels] : trial.asked.factors) {
    const std::string ratio = ratio_of(factor);
    const bool is_of_groups = groups != nullptr && groups->first == factor;
    const double sd = is_of_groups ? 0.0 : trial.values.at(ratio + "_sd");
    const double own_ratio =
        std::log(trial.values.at(ratio)) + sd * Random(trial.of_participant).split(ratio).normal();
    log_threshold += own_ratio * trial.place_of(factor);
  }
  return std::exp(log_threshold);
}

/// μ of the comparison.
double mean_impression(const TabulatedTrial& trial) {
  const Dimension& varied = *trial.asked.block.vary;
  const double value = std::get<double>(trial.trial.factors.at(varied.factor));
  const double shift = is_performance(trial.asked) ? 0.0 : trial.own(kShift);
  const double difference = value - *varied.standard - shift;
  const double size =
      std::pow(std::abs(difference) / threshold_in(trial), trial.values.at("slope"));
  return std::copysign(size, difference);
}

/// By position. Reversed where less of the parameter is sought.
std::vector<double> impressions_of(const TabulatedTrial& trial, bool seeks_less, Random& noise) {
  const double of_comparison = mean_impression(trial) * (seeks_less ? -1.0 : 1.0);
  std::vector<double> impressions{};
  for (const PlannedPresentation& surface : trial.trial.presentations) {
    const double mean = surface.role == "comparison" ? of_comparison : 0.0;
    impressions.push_back(mean + noise.normal());
  }
  return impressions;
}

Answer option_in_words(const TabulatedTrial& trial, bool is_yes) {
  const DiscriminationDesign& design = *trial.asked.block.design();
  const std::string_view wanted = is_yes ? design.yes : design.no;
  const auto& options = trial.question.options;
  const auto found = std::find_if(options.begin(), options.end(), [wanted](const Option& option) {
    return option.value == wanted;
  });
  return ChosenOption{static_cast<std::size_t>(found - options.begin())};
}

std::size_t place_of_greatest(const std::vector<double>& numbers) {
  return static_cast<std::size_t>(std::max_element(numbers.begin(), numbers.end()) -
                                  numbers.begin());
}

Answer decide_discrimination(const TabulatedTrial& trial) {
  const DiscriminationDesign& design = *trial.asked.block.design();
  Random noise = trial.of_response.split("impressions");
  if (trial.lapses()) {
    const bool can_abstain = trial.asked.question.allow_cannot_tell;
    return ChosenOption{static_cast<std::size_t>(
        noise.below(trial.question.options.size() - (can_abstain ? 1 : 0)))};
  }
  // Of a comparison, what is asked for; of a performance, the side of the levels. No response depends on what the
  // participant is asked to find where the odd one of three, or a difference, is to be found.
  const bool seeks_less = is_performance(trial.asked) ? is_below_the_standard(trial.asked)
                                                      : trial.asked.question.asks_for_less();
  std::vector<double> impressions = impressions_of(trial, seeks_less, noise);
  if (design.has_noise()) {
    const double criterion = trial.own(kCriterion);
    const double evidence =
        design.surfaces() == 1 ? impressions[0] : std::abs(impressions[0] - impressions[1]);
    return option_in_words(trial, evidence > criterion);
  }
  if (design.asks_for_odd_one) {
    const double mean = std::accumulate(impressions.begin(), impressions.end(), 0.0) /
                        static_cast<double>(impressions.size());
    for (double& impression : impressions) impression = std::abs(impression - mean);
  }
  impressions[0] += trial.own(kOrder);
  if (trial.asked.question.allow_cannot_tell && impressions.size() == 2 &&
      std::abs(impressions[0] - impressions[1]) < trial.values.at("unsure_within")) {
    return ChosenOption{trial.question.options.size() - 1};
  }
  return ChosenOption{place_of_greatest(impressions)};
}

}  // namespace

const ResponseTable& discrimination_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_discrimination,
                                        .respond = decide_discrimination};
  return kTable;
}

}  // namespace asperity
