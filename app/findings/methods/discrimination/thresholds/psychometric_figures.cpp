// Proportions correct by level, and the fitted psychometric function.

#include "app/findings/methods/discrimination/thresholds/psychometric_figures.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/number_text.h"
#include "analysis/psychometric/psychometric_fit.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/finding_parts.h"

namespace asperity {

namespace {

constexpr int kStepsOfCurve = 100;  // of a fitted curve
constexpr double kRoomBesideLevels =
    0.06;  // beyond the outermost levels, as a fraction of their range

std::optional<PsychometricShape> shape_of(const std::string& name) {
  if (name == "logistic") return PsychometricShape::logistic;
  if (name == "normal") return PsychometricShape::normal;
  if (name == "gumbel") return PsychometricShape::gumbel;
  if (name == "weibull") return PsychometricShape::weibull;
  return {};
}

std::optional<PsychometricFunction> function_of(const TidyInput& input, const FoundNumbers& found,
                                                const std::string& condition) {
  const auto shape = shape_of(input.options.text("shape"));
  const auto alpha = found.value("fit.alpha", condition);
  const auto beta = found.value("fit.beta", condition);
  const auto gamma = found.value("fit.gamma", condition);
  const auto lambda = found.value("fit.lambda", condition);
  if (!shape || !alpha || !beta || !gamma || !lambda) return {};
  return PsychometricFunction{
      .shape = *shape, .alpha = *alpha, .beta = *beta, .gamma = *gamma, .lambda = *lambda};
}

/// How the intervals of the thresholds were estimated.
Phrase words_of_intervals(FunctionsNote::Intervals intervals) {
  switch (intervals) {
    case FunctionsNote::Intervals::delta:
      return phrase("Figures", "by the delta method");
    case FunctionsNote::Intervals::resamples:
      return phrase("Figures", "by percentiles of a bootstrap of the three outcomes");
    case FunctionsNote::Intervals::delta_and_resamples:
      return phrase("Figures",
                    "by the delta method or, with responses “cannot tell”, by percentiles of a "
                    "bootstrap of the three outcomes");
    case FunctionsNote::Intervals::repeated_procedure:
    case FunctionsNote::Intervals::none:
      break;
  }
  return phrase("Figures", "by running the procedure again");
}

}  // namespace

Phrase note_on_functions(const FunctionsNote& note) {
  const bool is_correct = !note.percent_correct.empty();
  const Phrase functions =
      is_correct ? phrase("Figures",
                          "Filled symbols: proportions correct, larger for more trials. Curves: "
                          "maximum-likelihood psychometric functions.")
                 : phrase("Figures",
                          "Filled symbols: proportions of choices, larger for more trials. Curves: "
                          "maximum-likelihood psychometric functions.");
  if (note.thresholds == FunctionsNote::Thresholds::none) return functions;
  const Phrase marks =
      is_correct
          ? phrase("Figures", "%1 Open symbols: thresholds, the level of %2 % correct")
                .with(functions, note.percent_correct)
          : phrase("Figures", "%1 Open symbols: points of subjective equality").with(functions);
  if (note.intervals == FunctionsNote::Intervals::none) {
    return phrase("Figures", "%1, without CIs.").with(marks);
  }
  return phrase("Figures", "%1, with %2 % CIs %3.")
      .with(marks, note.confidence, words_of_intervals(note.intervals));
}

Figure psychometric_figure(const TidyInput& input, const FoundNumbers& found,
                           const std::string& unit, const std::optional<FigureSpan>& levels) {
  const double performance = input.options.number("pt");
  Figure figure{.name = "psychometric", .title = phrase("Figures", "Proportion correct by level")};
  const TidyTable& table = input.table();
  const LabelColumn conditions = table.all_labels("condition");
  const std::vector<double> x = table.all_numbers("x");
  const std::vector<std::uint64_t> trials = table.counts("n");
  // Not whole where a response "cannot tell" counts as the mean of a guess.
  const std::vector<double> hits = table.all_numbers("k");
  std::uint64_t most = 0;
  double low = 0.0;
  double high = 0.0;
  for (std::size_t row = 0; row < x.size(); ++row) {
    if (trials[row] == 0) continue;
    low = most == 0 ? x[row] : std::min(low, x[row]);
    high = most == 0 ? x[row] : std::max(high, x[row]);
    most = std::max(most, trials[row]);
  }
  if (most == 0) {
    figure.instead = phrase(
        "Figures",
        "No level has trials, so that there are no proportions correct; collect responses first.");
    return figure;
  }
  const FigureSpan own{low, high};
  if (levels) {
    low = levels->low;
    high = levels->high;
  }
  const double room = high > low ? kRoomBesideLevels * (high - low) : 0.5;
  // Levels that are magnitudes do not extend below zero.
  const double from = low >= 0.0 ? std::max(0.0, low - room) : low - room;
  const double to = high + room;
  const FigureSpan fitted{std::max(from, own.low - room), own.high + room};

  std::vector<FigureSeries> thresholds{};
  for (std::size_t i = 0; i < conditions.names.size(); ++i) {
    const std::string& name = conditions.names[i];
    FigureSeries& series = figure.series.emplace_back(
        FigureSeries{.name = words_of_condition(name), .style = static_cast<int>(i)});
    for (std::size_t row = 0; row < x.size(); ++row) {
      if (conditions.codes[row] != i || trials[row] == 0) continue;
      const double share = hits[row] / static_cast<double>(trials[row]);
      const double weight = static_cast<double>(trials[row]) / static_cast<double>(most);
      series.points.push_back(
          {.x = x[row], .y = share, .size = std::max(0.5, 1.2 * std::sqrt(weight))});
    }
    const auto function = function_of(input, found, name);
    if (!function) continue;
    std::vector<FigurePlace>& curve = series.lines.emplace_back();
    for (int step = 0; step <= kStepsOfCurve; ++step) {
      const double at =
          std::lerp(fitted.low, fitted.high, static_cast<double>(step) / kStepsOfCurve);
      curve.push_back({.x = at, .y = function->value(at)});
    }
    const Finding* threshold = found.find("threshold", name);
    if (threshold == nullptr || !threshold->value) continue;
    const double at = *threshold->value;
    if (at < from || at > to) continue;
    const FigurePoint mark{
        .x = at, .y = performance, .x_interval = interval_of(*threshold), .size = 1.3};
    thresholds.push_back({.style = static_cast<int>(i),
                          .hollow = true,
                          .points = {mark},
                          .lines = {{{.x = at, .y = performance}, {.x = at, .y = 0.0}}}});
  }
  figure.note = note_on_functions(
      {.percent_correct = number_text(100.0 * performance),
       .confidence = percent_of(found.all("threshold")),
       .thresholds =
           thresholds.empty() ? FunctionsNote::Thresholds::none : FunctionsNote::Thresholds::drawn,
       .intervals = draws_intervals(thresholds) ? FunctionsNote::Intervals::delta
                                                : FunctionsNote::Intervals::none});
  figure.series.insert(figure.series.end(), thresholds.begin(), thresholds.end());
  if (conditions.names.size() == 1) figure.series.front().name = {};
  if (input.options.text("gamma") != "free" && input.options.number("gamma") > 0.0) {
    figure.references.push_back({.at = FigureReference::At::y,
                                 .value = input.options.number("gamma"),
                                 .label = phrase("Figures", "chance level")});
  }
  figure.x = {.name = unit.empty() ? phrase("Figures", "level, in the unit of the table")
                                   : phrase("Figures", "level"),
              .unit = unit,
              .low = from,
              .high = to};
  figure.y = {.name = phrase("Figures", "proportion correct"), .low = 0.0, .high = 1.0};
  return figure;
}

}  // namespace asperity
