// The ROC of confidence ratings: points by criterion and the fitted normal model, of all participants and of each one.

#include "app/findings/methods/discrimination/sensitivity/roc_figures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/drawn_table.h"

namespace asperity {

namespace {

/// The points, without the two corners of the plot that belong to every ROC; the last name of their keys is the rating.
std::vector<FigurePoint> points_of(const FoundNumbers& found, const FindingKey& key) {
  std::vector<FigurePoint> points{};
  for (const Finding* const one : found.all("roc.fa")) {
    if (!one->value || one->key.without_last() != key) continue;
    if (const auto hit = found.value("roc.hit", one->key)) {
      points.push_back({.x = *one->value, .y = *hit});
    }
  }
  return points;
}

/// P(signal) = Φ((μ − c)/σ) over P(noise) = Φ(−c) for criteria c; empty where the model was not fitted.
std::vector<FigurePlace> fitted_curve(const FoundNumbers& found, const FindingKey& key) {
  constexpr int kSteps = 120;
  constexpr double kReach = 4.0;  // Φ(−4) is 0.00003
  const auto mean = found.value("uv.mu", key);
  const auto deviation = found.value("uv.sigma", key);
  std::vector<FigurePlace> curve{};
  if (!mean || !deviation) return curve;
  // The criteria reach to both ends of both distributions.
  const double low = std::min(-kReach, *mean - kReach * *deviation);
  const double high = std::max(kReach, *mean + kReach * *deviation);
  for (int step = 0; step <= kSteps; ++step) {
    const double criterion = std::lerp(high, low, static_cast<double>(step) / kSteps);
    curve.push_back(
        {.x = normal_below(-criterion), .y = normal_below((*mean - criterion) / *deviation)});
  }
  return curve;
}

/// "0.81"; empty where the model was not fitted.
Phrase fitted_area(const FoundNumbers& found, const FindingKey& key) {
  const Finding* const area = found.find("uv.az", key);
  if (area == nullptr || !area->value) return {};
  return display_number(*area->value);
}

/// The curves of one figure, whose table is in the study.
struct DrawnRocs {
  std::string participant{};  ///< "all", or a label
  std::string condition{};
  std::string parameter{};
  std::vector<RocCurve> curves{};
};

std::vector<DrawnRocs> drawn_rocs(const ResultTable& table) {
  std::vector<DrawnRocs> all{};
  for (const ResultRow& cells : table.rows) {
    const RowReader row(table, cells);
    const std::string participant = row.text(columns::kParticipant);
    const std::string condition = row.text(columns::kCondition);
    const std::string parameter = row.text(kParameterColumn);
    const double level = row.number(kLevelColumn).value_or(0.0);
    auto known = std::find_if(all.begin(), all.end(), [&](const DrawnRocs& each) {
      return each.participant == participant && each.condition == condition &&
             each.parameter == parameter;
    });
    if (known == all.end()) {
      known = all.insert(
          all.end(), {.participant = participant, .condition = condition, .parameter = parameter});
    }
    FindingKey key{condition, number_text(level)};
    if (participant != kAllParticipants) key = {key, participant};
    known->curves.push_back({.key = key, .name = stated_quantity(level, row.text(kUnitOfLevels))});
  }
  // Those of all participants first: they are the answer.
  std::stable_partition(all.begin(), all.end(),
                        [](const DrawnRocs& each) { return each.participant == kAllParticipants; });
  return all;
}

/// The only question about areas; empty where there are several, of different parameters.
std::string question_about_areas(const AnalysisOutcome& outcome) {
  std::string name{};
  for (const AnsweredQuestion& asked : outcome.questions) {
    if (asked.table != kConfidenceRoc) continue;
    if (!name.empty()) return {};
    name = asked.name;
  }
  return name;
}

}  // namespace

Figure roc_figure(const FoundNumbers& found, std::span<const RocCurve> curves) {
  Figure figure{.name = "roc",
                .title = phrase("Figures", "ROC of the confidence ratings"),
                .shape = FigureShape::square};
  Phrase areas{};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    FigureSeries series{.name = curves.size() > 1 ? curves[i].name : Phrase{},
                        .style = static_cast<int>(i),
                        .points = points_of(found, curves[i].key)};
    if (series.points.empty()) continue;
    if (auto curve = fitted_curve(found, curves[i].key); !curve.empty()) {
      series.lines.push_back(std::move(curve));
    }
    figure.series.push_back(std::move(series));
    Phrase area = fitted_area(found, curves[i].key);
    if (area.empty()) continue;
    if (!curves[i].name.empty()) {
      area = phrase("Figures", "%1: %2").with(curves[i].name, area);
    }
    areas = areas.empty() ? area : phrase("Figures", "%1; %2").with(areas, area);
  }
  if (figure.series.empty()) {
    figure.instead = phrase("Figures",
                            "An ROC needs trials with and trials without a signal; collect "
                            "responses of both kinds first.");
    return figure;
  }
  const Phrase marks =
      phrase("Figures",
             "Points: proportions of the trials with a signal (hits) and without one (false "
             "alarms) with at least this rating, a point per criterion.");
  figure.note = areas.empty() ? marks
                              : phrase("Figures",
                                       "%1 Curves: normal model with unequal variances, by maximum "
                                       "likelihood. Area under the curve, A_z: %2.")
                                    .with(marks, areas);
  figure.x = {.name = phrase("Figures", "proportion of false alarms"), .low = 0.0, .high = 1.0};
  figure.y = {.name = phrase("Figures", "proportion of hits"), .low = 0.0, .high = 1.0};
  figure.references.push_back(
      {.at = FigureReference::At::equal, .label = phrase("Figures", "chance level")});
  return figure;
}

std::vector<Figure> roc_figures(const ResultTable& table, const AnalysisOutcome& outcome) {
  const FoundNumbers found(outcome.findings, kConfidenceRoc);
  const std::vector<DrawnRocs> rocs = drawn_rocs(table);
  const auto differ = [&rocs](std::string DrawnRocs::*member) {
    return std::any_of(rocs.begin(), rocs.end(),
                       [&](const DrawnRocs& each) { return each.*member != rocs.front().*member; });
  };
  const bool has_several = differ(&DrawnRocs::condition);
  const bool has_several_tasks = differ(&DrawnRocs::parameter);
  const std::string question = question_about_areas(outcome);
  std::vector<Figure> figures{};
  for (const DrawnRocs& drawn : rocs) {
    Figure figure = roc_figure(found, drawn.curves);
    const bool is_of_all = drawn.participant == kAllParticipants;
    if (is_of_all) figure.question = question;
    std::string name = is_of_all ? "roc" : "roc_" + drawn.participant;
    if (!is_of_all) {
      figure.title = phrase("Figures", "ROC of the confidence ratings of participant %1")
                         .with(drawn.participant);
    }
    if (has_several) {
      name += '_' + drawn.condition;
      figure.title =
          phrase("Figures", "%1: %2").with(figure.title, words_of_condition(drawn.condition));
    }
    if (has_several_tasks) {
      name += '_' + drawn.parameter;
      figure.title =
          phrase("Figures", "%1: %2").with(figure.title, words_of_parameter(drawn.parameter));
    }
    figure.name = figure_file_name(name);
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace asperity
