// Psychometric functions of the participants of a discrimination, and their thresholds by condition.

#include "app/findings/methods/discrimination/thresholds/threshold_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "analysis/numbers/number_text.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/thresholds/detection_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/methods/discrimination/thresholds/psychometric_figures.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/single_participants.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// The responses of one participant, with the conditions of one judgement.
struct DrawnFunctions {
  std::string participant{};
  std::string parameter{};
  std::string unit{};
  bool is_performance = false;
  const DiscriminationDesign* design = &two_alternatives();
  LabelRows conditions{};
  std::set<std::string> names{};
  std::set<std::string> unsure{};  ///< the conditions with responses "cannot tell"
  NumberColumn levels{};
  NumberColumn trials{};
  NumberColumn hits{};
  FigureSpan range{};  ///< of the levels, in the stored unit

  bool has_axis_of(const DrawnFunctions& other) const {
    return parameter == other.parameter && is_performance == other.is_performance &&
           design == other.design;
  }
};

/// The design of a function; that of two alternatives where the findings state none.
const DiscriminationDesign& design_of(const FoundNumbers& functions, const FindingKey& key) {
  const Finding* const stated = functions.find("fit.design", key);
  const DiscriminationDesign* const design =
      stated == nullptr ? nullptr : find_design(stated->word);
  return design == nullptr ? two_alternatives() : *design;
}

/// By participant, parameter, judgement and design, in the order of the table.
std::vector<DrawnFunctions> drawn_functions(const ResultTable& table,
                                            const FoundNumbers& functions) {
  std::vector<DrawnFunctions> all{};
  for (const ResultRow& cells : table.rows) {
    const RowReader row(table, cells);
    const std::optional<double> difference = row.number(columns::kDifference);
    const std::string participant = row.text(columns::kParticipant);
    const std::string parameter = row.text(kParameterColumn);
    const std::string condition = row.text(columns::kCondition);
    const DiscriminationDesign& design = design_of(functions, {participant, condition});
    auto known = std::find_if(all.begin(), all.end(), [&](const DrawnFunctions& each) {
      return each.participant == participant && each.parameter == parameter &&
             each.design == &design && each.is_performance == difference.has_value();
    });
    if (known == all.end()) {
      all.push_back({.participant = participant,
                     .parameter = parameter,
                     .unit = row.text(kUnitOfLevels),
                     .is_performance = difference.has_value(),
                     .design = &design});
      known = all.end() - 1;
    }
    const double level =
        difference ? std::abs(*difference) : row.number(kLevelColumn).value_or(0.0);
    if (known->levels.empty()) known->range = {level, level};
    known->conditions.add(condition);
    known->names.insert(condition);
    known->levels.push_back(level);
    known->trials.push_back(row.number(columns::kResponses));
    known->hits.push_back(row.number(columns::kHits));
    if (row.number(kUnsureColumn).value_or(0.0) > 0.0) known->unsure.insert(condition);
    known->range.low = std::min(known->range.low, level);
    known->range.high = std::max(known->range.high, level);
  }
  // Participants are compared by eye: their levels have one axis.
  std::vector<FigureSpan> ranges{};
  for (const DrawnFunctions& each : all) {
    FigureSpan& range = ranges.emplace_back(each.range);
    for (const DrawnFunctions& other : all) {
      if (!each.has_axis_of(other)) continue;
      range.low = std::min(range.low, other.range.low);
      range.high = std::max(range.high, other.range.high);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].range = ranges[i];
  return all;
}

/// The findings of the function of one condition in the unit that is drawn, with the names of the family `psyfit`.
void add_function(const FoundNumbers& functions, const FoundNumbers& thresholds,
                  const DrawnFunctions& drawn, const std::string& condition, const DrawnUnit& unit,
                  std::vector<Finding>& made) {
  const FindingKey key{drawn.participant, condition};
  for (const QuantityName quantity :
       std::initializer_list<QuantityName>{"fit.alpha", "fit.beta", "fit.gamma", "fit.lambda"}) {
    const Finding* const found = functions.find(quantity, key);
    if (found == nullptr || !found->value) continue;
    Finding scaled = *found;
    scaled.key = condition;
    if (is(scaled, "fit.alpha")) *scaled.value /= unit.size;
    if (is(scaled, "fit.beta") && !drawn.is_performance) *scaled.value *= unit.size;
    made.push_back(std::move(scaled));
  }
  const Finding* const threshold =
      thresholds.find(drawn.is_performance ? QuantityName("jnd") : "pse", key);
  if (threshold == nullptr || !threshold->value) return;
  Finding scaled = *threshold;
  scaled.quantity = "threshold";
  scaled.key = condition;
  for (std::optional<double>* const number : {&scaled.value, &scaled.low, &scaled.high}) {
    if (*number) **number /= unit.size;
  }
  made.push_back(std::move(scaled));
}

TidyInput input_of_functions(DrawnFunctions& drawn, const DrawnUnit& unit) {
  for (std::optional<double>& level : drawn.levels) *level /= unit.size;
  TidyInput input{};
  input.tables.emplace_back(
      std::vector<TidyTable::Column>{{"condition", std::move(drawn.conditions).take()},
                                     {"x", std::move(drawn.levels)},
                                     {"n", std::move(drawn.trials)},
                                     {"k", std::move(drawn.hits)}},
      "the responses");
  input.options.set("shape", std::string(drawn.is_performance ? "weibull" : "normal"));
  input.options.set("gamma",
                    drawn.is_performance ? drawn.design->guess_rate() : kSymmetricLapseRate);
  input.options.set("pt", drawn.is_performance ? proportion_at_threshold(*drawn.design) : 0.5);
  return input;
}

/// Adds the curves of the designs with options in words, and the differences with d′ = 1.
void add_detections(const DrawnFunctions& drawn, const std::vector<std::string>& conditions,
                    const FoundNumbers& functions, const FoundNumbers& thresholds,
                    const DrawnUnit& unit, Figure& figure) {
  constexpr int kStepsOfDetection = 100;
  std::vector<FigureSeries> marks{};
  for (std::size_t i = 0; i < conditions.size() && i < figure.series.size(); ++i) {
    const FindingKey key{drawn.participant, conditions[i]};
    const auto function = detection_function(*drawn.design, functions, key);
    if (!function) continue;
    std::vector<FigurePlace>& curve = figure.series[i].lines.emplace_back();
    for (int step = 0; step <= kStepsOfDetection; ++step) {
      const double x = drawn.range.high * step / kStepsOfDetection;
      curve.push_back({.x = x / unit.size, .y = function->value(x)});
    }
    const Finding* const threshold = thresholds.find("jnd.dprime1", key);
    if (threshold == nullptr || !threshold->value) continue;
    FigurePoint mark{
        .x = *threshold->value / unit.size, .y = function->value(*threshold->value), .size = 1.3};
    if (threshold->low && threshold->high) {
      mark.x_interval = FigureSpan{*threshold->low / unit.size, *threshold->high / unit.size};
    }
    marks.push_back({.style = static_cast<int>(i),
                     .hollow = true,
                     .points = {mark},
                     .lines = {{{.x = mark.x, .y = mark.y}, {.x = mark.x, .y = 0.0}}}});
  }
  const bool has_intervals = draws_intervals(marks);
  const bool has_marks = !marks.empty();
  figure.series.insert(figure.series.end(), marks.begin(), marks.end());
  figure.references.clear();
  const std::string yes(drawn.design->yes);
  figure.y.name = phrase("Figures", "proportion of responses “%1”").with(yes);
  figure.note = phrase("Figures",
                       "Filled symbols: proportions of responses “%1”, larger for more trials; "
                       "those at a difference of 0 are false alarms. Curves: maximum-likelihood "
                       "functions of signal detection.")
                    .with(yes);
  if (!has_marks) return;
  figure.note =
      (has_intervals ? phrase("Figures", "%1 Open symbols: differences with d′ = 1, with 95 % CIs.")
                     : phrase("Figures", "%1 Open symbols: differences with d′ = 1, without CIs."))
          .with(figure.note);
}

bool draws_thresholds(const Figure& figure) {
  return std::any_of(figure.series.begin(), figure.series.end(),
                     [](const FigureSeries& one) { return one.hollow && !one.points.empty(); });
}

/// How the intervals of the drawn thresholds were estimated, where there are any.
FunctionsNote::Intervals method_of_intervals(const DrawnFunctions& drawn, const Figure& figure,
                                             const FoundNumbers& thresholds) {
  if (!draws_intervals(figure.series)) return FunctionsNote::Intervals::none;
  const bool is_repeated =
      std::any_of(drawn.names.begin(), drawn.names.end(), [&](const std::string& condition) {
        return thresholds.find("without", {drawn.participant, condition}) != nullptr;
      });
  if (is_repeated) return FunctionsNote::Intervals::repeated_procedure;
  if (drawn.unsure.empty()) return FunctionsNote::Intervals::delta;
  return drawn.unsure.size() == drawn.names.size() ? FunctionsNote::Intervals::resamples
                                                   : FunctionsNote::Intervals::delta_and_resamples;
}

Figure figure_of_functions(DrawnFunctions drawn, const FoundNumbers& functions,
                           const FoundNumbers& thresholds) {
  const DrawnUnit unit =
      drawn_unit(drawn.unit, std::max(std::abs(drawn.range.low), std::abs(drawn.range.high)));
  std::vector<Finding> findings{};
  for (const std::string& condition : drawn.names) {
    add_function(functions, thresholds, drawn, condition, unit, findings);
  }
  const TidyInput input = input_of_functions(drawn, unit);
  Figure figure =
      psychometric_figure(input, FoundNumbers(findings), unit.text,
                          FigureSpan{drawn.range.low / unit.size, drawn.range.high / unit.size});
  const std::string parameter = words_of_parameter(drawn.parameter);
  figure.name = figure_file_name("psychometric_" + drawn.participant +
                                 (drawn.is_performance ? "" : "_comparison"));
  figure.title =
      phrase("Figures", "Psychometric functions of participant %1").with(drawn.participant);
  if (drawn.design->has_noise()) {
    figure.name =
        figure_file_name("psychometric_" + drawn.participant + '_' + std::string(drawn.design->id));
    figure.x.name = phrase("Figures", "difference of the %1 from the standard").with(parameter);
    add_detections(drawn, input.table().all_labels("condition").names, functions, thresholds, unit,
                   figure);
    return figure;
  }
  const auto marks =
      draws_thresholds(figure) ? FunctionsNote::Thresholds::drawn : FunctionsNote::Thresholds::none;
  if (drawn.is_performance) {
    figure.x.name = phrase("Figures", "difference of the %1 from the standard").with(parameter);
    if (drawn.design->is_choice_of_three()) {
      figure.name = figure_file_name("psychometric_" + drawn.participant + '_' +
                                     std::string(drawn.design->id));
    }
    figure.note =
        note_on_functions({.percent_correct = number_text(
                               std::round(1000.0 * proportion_at_threshold(*drawn.design)) / 10.0),
                           .thresholds = marks,
                           .intervals = method_of_intervals(drawn, figure, thresholds)});
    return figure;
  }
  figure.note = note_on_functions(
      {.thresholds = marks, .intervals = method_of_intervals(drawn, figure, thresholds)});
  figure.x.name = phrase("Figures", "%1 of the comparison").with(parameter);
  figure.y.name = phrase("Figures", "proportion of choices");
  figure.references.clear();
  const Finding* const standard =
      thresholds.find("standard", {drawn.participant, *drawn.names.begin()});
  if (standard != nullptr && standard->value) {
    figure.references.push_back({.at = FigureReference::At::x,
                                 .value = *standard->value / unit.size,
                                 .label = phrase("Figures", "standard")});
  }
  return figure;
}

/// The numbers of one threshold in the tables.
struct DrawnThreshold {
  ResultColumn threshold{};
  const char* figure = "";
  const char* question = "";
  Phrase title{};
  Phrase axis{};
  ResultColumn mean{};  ///< of the table of means
};

/// Explains only the marks that are drawn. A point of subjective equality has an arithmetic mean.
Phrase note_on_mean_thresholds(bool is_arithmetic, bool has_intervals) {
  const Phrase points =
      is_arithmetic
          ? phrase("Figures",
                   "Points are means over the participants whose threshold could be estimated")
          : phrase("Figures",
                   "Points are geometric means over the participants whose threshold could be "
                   "estimated");
  if (!has_intervals) return phrase("Figures", "%1; there are no CIs.").with(points);
  return (is_arithmetic
              ? phrase("Figures", "%1; error bars show their t-based 95 % CIs.")
              : phrase("Figures",
                       "%1; error bars show their t-based 95 % CIs on the logarithmic scale."))
      .with(points);
}

/// Means with their intervals, a row per condition, and the participants behind them; nothing without a mean.
std::optional<Figure> figure_of_thresholds(const DrawnThreshold& drawn, const ResultTable& means,
                                           const ResultTable& thresholds) {
  double greatest = 0.0;
  double lowest = std::numeric_limits<double>::infinity();
  std::string unit{};
  const auto reach = [&](const std::optional<double>& number) {
    if (!number) return;
    greatest = std::max(greatest, *number);
    lowest = std::min(lowest, *number);
  };
  std::vector<RowReader> rows{};
  for (const ResultRow& cells : means.rows) {
    const RowReader row(means, cells);
    if (row.text(columns::kMeasure) != drawn.threshold.id) continue;
    rows.push_back(row);
    unit = row.text(kUnitOfLevels);
    const Interval interval = row.interval(drawn.mean);
    for (const auto& number : {row.number(drawn.mean), interval.low, interval.high}) reach(number);
  }
  if (rows.empty()) return std::nullopt;
  std::map<std::string, std::vector<double>> singles{};
  for (const ResultRow& cells : thresholds.rows) {
    const RowReader row(thresholds, cells);
    const std::optional<double> value = row.number(drawn.threshold);
    if (!value) continue;
    singles[row.text(columns::kCondition)].push_back(*value);
    reach(value);
  }
  const DrawnUnit shown = drawn_unit(unit, std::abs(greatest));
  Figure figure{.name = drawn.figure,
                .question = drawn.question,
                .title = drawn.title,
                .shape = FigureShape::rows};
  const bool is_pse = drawn.threshold.is_same(kPseColumn);
  const double room = 0.06 * (greatest - (is_pse ? lowest : std::min(0.0, lowest)));
  figure.x = {.unit = shown.text,
              .low = (is_pse ? lowest - room : std::min(0.0, lowest)) / shown.size,
              .high = (greatest + (room > 0.0 ? room : 1e-9)) / shown.size};
  FigureSeries points{};
  bool has_bound = false;
  std::vector<SingleValues> behind{};
  for (const RowReader& row : rows) {
    const auto scaled = [&shown](const std::optional<double>& number) {
      return number ? std::optional(*number / shown.size) : std::nullopt;
    };
    const Interval interval = row.interval(drawn.mean);
    const auto place = static_cast<double>(figure.y.places.size());
    if (const auto mean = scaled(row.number(drawn.mean))) {
      FigurePoint point{.x = *mean, .y = place};
      if (const auto low = scaled(interval.low), high = scaled(interval.high); low && high) {
        point.x_interval = FigureSpan{*low, *high};
      }
      points.points.push_back(point);
    }
    has_bound = has_bound || !row.text(columns::kStatus).empty();
    const std::string condition = row.text(columns::kCondition);
    std::vector<double> own = singles[condition];
    for (double& value : own) value /= shown.size;
    behind.push_back({.place = place, .values = std::move(own)});
    figure.y.places.push_back(words_of_condition_or_all(condition));
  }
  const bool has_intervals = draws_intervals(std::span(&points, 1));
  figure.x.name =
      has_intervals ? phrase("Figures", "%1 with its 95 % CI").with(drawn.axis) : drawn.axis;
  figure.note = note_on_mean_thresholds(is_pse, has_intervals);
  figure.series.push_back(singles_in_rows(behind, figure.x, 0));
  figure.series.push_back(std::move(points));
  if (has_bound) {
    figure.note = phrase("Figures",
                         "%1 A mean that leaves out thresholds outside the presented levels has no "
                         "error bar; it is an upper bound if all of these lie below the levels, a "
                         "lower bound if all lie above, and otherwise not drawn.")
                      .with(figure.note);
  }
  figure.note = with_note_on_singles(figure.note, figure);
  return figure;
}

}  // namespace

std::vector<Figure> threshold_figures(const ResultTable& means, const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  const ResultTable* const thresholds = table_named(outcome, kThresholds);
  if (thresholds == nullptr) return figures;
  const std::array kDrawn{
      DrawnThreshold{kPseColumn, "points_of_subjective_equality", "point_of_subjective_equality",
                     phrase("Figures", "Points of subjective equality"),
                     phrase("Figures", "point of subjective equality, mean"), columns::kMean},
      DrawnThreshold{kJndColumn, "thresholds", "threshold", phrase("Figures", "Thresholds"),
                     phrase("Figures", "threshold, geometric mean"), kGeometricMean}};
  bool has_proportion = false;  // a threshold at a proportion correct
  for (const DrawnThreshold& drawn : kDrawn) {
    auto figure = figure_of_thresholds(drawn, means, *thresholds);
    has_proportion = has_proportion || (figure && drawn.threshold.is_same(kJndColumn));
    if (figure) figures.push_back(std::move(*figure));
  }
  if (has_proportion) return figures;
  const DrawnThreshold at_unit{kJndDprime1Column,
                               "thresholds",
                               "threshold",
                               phrase("Figures", "Thresholds"),
                               phrase("Figures", "difference with d′ = 1, geometric mean"),
                               kGeometricMean};
  auto figure = figure_of_thresholds(at_unit, means, *thresholds);
  if (figure) figures.push_back(std::move(*figure));
  return figures;
}

std::vector<Figure> function_figures(const ResultTable& responses, const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  const FoundNumbers functions(outcome.findings, kPsychometric);
  const FoundNumbers thresholds(outcome.findings, kThresholds);
  for (DrawnFunctions& drawn : drawn_functions(responses, functions)) {
    figures.push_back(figure_of_functions(std::move(drawn), functions, thresholds));
  }
  return figures;
}

}  // namespace asperity
