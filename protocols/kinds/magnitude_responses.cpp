// Draws logarithms of estimates about a curve of the predictor, with ratios of conditions.

#include "protocols/kinds/magnitude_responses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "protocols/answers/stored_number.h"

namespace asperity {

namespace {

constexpr const char* kExponent = "exponent";
constexpr const char* kCurvature = "curvature";
constexpr const char* kPeak = "peak";
constexpr const char* kRatio = "ratio";

const EstimationDeclaration& estimation_of(const TabulatedQuestion& asked) {
  return *asked.protocol.estimation;
}

/// The levels of the analysed factor in the trials of the block, in the order of the protocol.
std::vector<std::string> analysed_levels(const TabulatedQuestion& asked) {
  const std::string& factor = estimation_of(asked).factor();
  const auto known = std::find_if(asked.factors.begin(), asked.factors.end(),
                                  [&factor](const auto& each) { return each.first == factor; });
  if (known != asked.factors.end()) return known->second;
  std::vector<std::string> levels{};
  const bool is_varied = asked.block.vary && asked.block.vary->factor == factor;
  if (is_varied) {
    for (const double value : asked.values) levels.push_back(text_of(Level{value}));
  } else if (const auto declared = asked.protocol.factors.find(factor);
             declared != asked.protocol.factors.end()) {
    for (const Level& level : declared->second.levels) levels.push_back(text_of(level));
  }
  return levels;
}

/// The predictor of a level; nothing where the protocol states none for it.
std::optional<double> predictor_of_level(const EstimationDeclaration& estimation,
                                         const std::string& level) {
  const auto& stated =
      estimation.items.empty() ? estimation.spacing_m : estimation.predictor_values;
  const auto known = stated.find(level);
  if (known != stated.end()) return known->second;
  if (estimation.items.empty() || estimation.predictor == kLevelPredictor)
    return stored_number(level);
  return std::nullopt;
}

/// Whether every level has a predictor above 0.
bool has_predictor(const TabulatedQuestion& asked) {
  const std::vector<std::string> levels = analysed_levels(asked);
  return !levels.empty() && std::all_of(levels.begin(), levels.end(), [&](const auto& level) {
    const auto value = predictor_of_level(estimation_of(asked), level);
    return value && *value > 0.0;
  });
}

double mean_of_logarithms(const TabulatedQuestion& asked) {
  const std::vector<std::string> levels = analysed_levels(asked);
  double sum = 0.0;
  for (const std::string& level : levels) {
    sum += std::log10(*predictor_of_level(estimation_of(asked), level));
  }
  return sum / static_cast<double>(levels.size());
}

/// What is estimated.
Phrase estimate_text(const TabulatedQuestion& asked) {
  return std::holds_alternative<LineForm>(asked.question.form)
             ? phrase("Responses", "length of the drawn line")
             : phrase("Responses", "estimate");
}

/// The conditions, if the block has several.
bool has_conditions(const TabulatedQuestion& asked) {
  return estimation_of(asked).conditions.size() > 1;
}

void add_curve(const TabulatedQuestion& asked, ParameterList& list) {
  const bool is_of_spacings = estimation_of(asked).items.empty();
  const Phrase estimate = estimate_text(asked);
  if (!has_predictor(asked)) {
    list.effect(
        {.effect = {.name = kRatio,
                    .range = ParameterRange::positive,
                    .unit = "ratio",
                    .meaning = text_of(
                        {.of_ends = phrase("Responses", "%3 of %1 divided by that of %2"),
                         .in_order = phrase(
                             "Responses",
                             "%1; the stimuli between them are equally spaced, in the order %2"),
                         .details = estimate},
                        analysed_levels(asked)),
                    .null_value = 1.0},
         .tests = {"stimuli", "spacing"},
         .sd_meaning = phrase("Responses",
                              "SD over participants of the natural logarithm of the ratio of any "
                              "two stimuli"),
         .usual_sd = 0.3});
    return;
  }
  list.effect(
      {.effect = {.name = kExponent,
                  .meaning = (is_of_spacings
                                  ? phrase("Responses",
                                           "exponent of the power function of the %1 over the "
                                           "spacing; above 0, the first grows with the second")
                                  : phrase("Responses",
                                           "exponent of the power function of the %1 over the "
                                           "predictor; above 0, the first grows with the second"))
                                 .with(estimate)},
       .tests = {"spacing", "stimuli", "exponent"},
       .sd_meaning = phrase("Responses", "SD over participants of the exponent"),
       .usual_sd = 0.2});
  if (!is_of_spacings) return;
  list.effect(
      {.effect = {.name = kCurvature,
                  .meaning =
                      phrase("Responses",
                             "decrease of the logarithm (base 10) of the %1 from the spacing of "
                             "maximum roughness to 10 times this spacing, and to a tenth of it")
                          .with(estimate)},
       .tests = {"peaks"},
       .sd_meaning = phrase("Responses", "SD over participants of this decrease"),
       .usual_sd = 0.2});
  list.assumed(
      {.name = kPeak,
       .range = ParameterRange::positive,
       .unit = "m",
       .meaning = phrase("Responses",
                         "spacing of maximum roughness of the median participant if the "
                         "exponent is 0; otherwise it is multiplied by 10^(exponent / (2 · "
                         "curvature))"),
       .value = std::pow(10.0, mean_of_logarithms(asked))});
  list.assumed({.name = "peak_sd",
                .range = ParameterRange::not_negative,
                .meaning = phrase("Responses",
                                  "SD over participants of the natural logarithm of this spacing"),
                .value = 0.2});
}

void add_conditions(const TabulatedQuestion& asked, ParameterList& list) {
  if (!has_conditions(asked)) return;
  const std::string last = quoted_name(estimation_of(asked).conditions.back());
  const std::string first = quoted_name(estimation_of(asked).conditions.front());
  list.effect({.effect = {.name = "condition.ratio",
                          .range = ParameterRange::positive,
                          .unit = "ratio",
                          .meaning = phrase("Responses", "%1 in %2 divided by that in %3")
                                         .with(estimate_text(asked), last, first),
                          .null_value = 1.0},
               .tests = {"condition"},
               .sd_meaning = phrase("Responses",
                                    "SD over participants of the natural logarithm of this ratio"),
               .usual_sd = 0.2});
  if (!has_predictor(asked)) return;
  list.effect(
      {.effect = {.name = "condition.exponent",
                  .meaning =
                      phrase("Responses", "exponent in %1 minus that in %2").with(last, first)},
       .tests = {"interaction", "stimuli_by_condition"},
       .sd_meaning = phrase("Responses", "SD over participants of this difference"),
       .usual_sd = 0.1});
  if (!estimation_of(asked).items.empty()) return;
  list.effect({.effect = {.name = "condition.peak_ratio",
                          .range = ParameterRange::positive,
                          .unit = "ratio",
                          .meaning = phrase("Responses",
                                            "spacing of maximum roughness in %1 divided by that in "
                                            "%2, if the exponents in both are equal")
                                         .with(last, first),
                          .null_value = 1.0},
               .tests = {"peaks", "interaction"},
               .sd_meaning = phrase("Responses",
                                    "SD over participants of the natural logarithm of this ratio"),
               .usual_sd = 0.1});
}

std::vector<ResponseParameter> parameters_of_magnitude(const TabulatedQuestion& asked) {
  ParameterList list(asked);
  add_curve(asked, list);
  add_conditions(asked, list);
  const bool is_line = std::holds_alternative<LineForm>(asked.question.form);
  const bool has_standard = estimation_of(asked).modulus.has_value();
  if (!has_standard) {
    list.assumed(
        {.name = "level",
         .meaning = is_line
                        ? phrase("Responses",
                                 "logarithm (base 10) of the mean line, relative to the longest")
                        : phrase("Responses", "logarithm (base 10) of the mean estimate"),
         .value = is_line ? -0.5 : 1.0});
    list.assumed({.name = "level_sd",
                  .range = ParameterRange::not_negative,
                  .meaning = phrase("Responses", "SD over participants of this logarithm"),
                  .value = is_line ? 0.1 : 0.3});
  }
  list.assumed(
      {.name = "noise_sd",
       .range = ParameterRange::not_negative,
       .meaning = phrase("Responses",
                         "SD of the logarithm (base 10) of the estimates of one participant for "
                         "one stimulus"),
       .value = 0.1});
  list.lapse();
  return list.take();
}

Phrase refusal_of_magnitude(const TabulatedQuestion& asked) {
  const EstimationDeclaration& estimation = estimation_of(asked);
  const bool is_stated = estimation.items.empty() || estimation.predictor.empty() ||
                         estimation.predictor == kLevelPredictor ||
                         estimation.predictor == kValuePredictor;
  if (is_stated) return {};
  return phrase("Responses", "the predictor %1 is measured on the surfaces as they are rendered")
      .with(quoted_name(estimation.predictor));
}

double natural_to_decimal(double logarithm) { return logarithm / std::numbers::ln10; }

/// The logarithm (base 10) of the participant's own ratio.
double own_log_ratio(const TabulatedTrial& trial, const std::string& name) {
  const double natural =
      std::log(trial.values.at(name)) +
      trial.values.at(name + "_sd") * Random(trial.of_participant).split(name).normal();
  return natural_to_decimal(natural);
}

/// The place of the condition of the trial, from −½ to ½.
double place_of_condition(const TabulatedTrial& trial) {
  const EstimationDeclaration& estimation = estimation_of(trial.asked);
  const auto level = trial.trial.factors.find(estimation.condition);
  if (level == trial.trial.factors.end()) return 0.0;
  return place_among(estimation.conditions, text_of(level->second));
}

/// The part of L that depends on the level of the analysed factor.
double curve_at(const TabulatedTrial& trial, const std::string& level, double condition) {
  const TabulatedQuestion& asked = trial.asked;
  if (!has_predictor(asked)) {
    const double sd = natural_to_decimal(trial.values.at(std::string(kRatio) + "_sd"));
    return natural_to_decimal(std::log(trial.values.at(kRatio))) *
               place_among(analysed_levels(asked), level) +
           trial.own_of(kRatio, level, sd / std::numbers::sqrt2);
  }
  const double logarithm = std::log10(*predictor_of_level(estimation_of(asked), level));
  double exponent = trial.own(kExponent);
  if (has_conditions(asked)) exponent += trial.own("condition.exponent") * condition;
  double curve = exponent * (logarithm - mean_of_logarithms(asked));
  if (!estimation_of(asked).items.empty()) return curve;
  double peak = own_log_ratio(trial, kPeak);
  if (has_conditions(asked)) peak += own_log_ratio(trial, "condition.peak_ratio") * condition;
  return curve - trial.own(kCurvature) * (logarithm - peak) * (logarithm - peak);
}

double with_two_digits(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::round(number / unit) * unit;
}

Answer estimate_magnitude(const TabulatedTrial& trial) {
  const EstimationDeclaration& estimation = estimation_of(trial.asked);
  Random noise = trial.of_response.split("estimate");
  constexpr double kLapse_sd = 0.3;
  double logarithm =
      estimation.modulus ? std::log10(estimation.modulus->value) : trial.own("level");
  if (trial.lapses()) {
    logarithm += kLapse_sd * noise.normal();
  } else {
    const double condition = place_of_condition(trial);
    logarithm += trial.values.at("noise_sd") * noise.normal() +
                 curve_at(trial, text_of(trial.trial.factors.at(estimation.factor())), condition);
    if (estimation.modulus) logarithm -= curve_at(trial, estimation.modulus->standard, condition);
    if (has_conditions(trial.asked)) {
      logarithm += own_log_ratio(trial, "condition.ratio") * condition;
    }
  }
  const double number = std::pow(10.0, logarithm);
  if (std::holds_alternative<LineForm>(trial.question.form)) {
    return DrawnLength{
        std::clamp(static_cast<int>(std::lround(number * LineForm::kSteps)), 1, LineForm::kSteps)};
  }
  return GivenNumber{with_two_digits(number)};
}

}  // namespace

const ResponseTable& magnitude_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_magnitude,
                                        .refusal = refusal_of_magnitude,
                                        .respond = estimate_magnitude};
  return kTable;
}

}  // namespace asperity
