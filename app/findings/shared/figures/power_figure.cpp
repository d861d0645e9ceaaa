// Power of planned tests by sample size.

#include "app/findings/shared/figures/power_figure.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace asperity {

namespace {

constexpr double kWanted = 0.8;         // the customary target of plans
constexpr std::size_t kMostCurves = 6;  // as many as are distinguishable

/// The columns that define a plan apart from its size, with their display names.
constexpr std::array kColumns{std::pair{"kind", ""},
                              std::pair{"alpha", "α"},
                              std::pair{"k", "k"},
                              std::pair{"p0", "p₀"},
                              std::pair{"p1", "p₁"},
                              std::pair{"theta", "θ"},
                              std::pair{"d", "d"},
                              std::pair{"f", "f"},
                              std::pair{"rho", "ρ"},
                              std::pair{"eps", "ε"},
                              std::pair{"probs", "proportions"}};

Phrase words_of_kind(const std::string& kind) {
  static const std::map<std::string, Phrase> kWords{
      {"binom_greater", phrase("Figures", "exact binomial test, one-sided")},
      {"binom_two", phrase("Figures", "exact binomial test, two-sided")},
      {"chisq_uniform_exact", phrase("Figures", "χ² test of equal proportions")},
      {"fisher_two", phrase("Figures", "Fisher's exact test")},
      {"mafc_dprime", phrase("Figures", "proportion correct for a given d′")},
      {"matching_known", phrase("Figures", "matching, some items known")},
      {"matching_mallows", phrase("Figures", "matching, Mallows' model")},
      {"paired_t", phrase("Figures", "paired t test")},
      {"rm_anova", phrase("Figures", "repeated-measures ANOVA")}};
  const auto found = kWords.find(kind);
  return found == kWords.end() ? Phrase(kind) : found->second;
}

struct PlannedPoint {
  std::string id{};
  std::vector<std::string> settings{};  ///< by column
  double n = 0.0;
  double power = 0.0;
};

std::vector<PlannedPoint> planned_in(const TidyInput& input, const FoundNumbers& found) {
  std::vector<PlannedPoint> plans{};
  if (found.all("power").empty()) return plans;
  const TidyTable& table = input.table();
  const auto ids = table.texts("id");
  const std::vector<double> sizes = table.all_numbers("n");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto power = found.value("power", ids[row]);
    if (!power) continue;
    PlannedPoint& plan = plans.emplace_back(
        PlannedPoint{.id = std::string(ids[row]), .n = sizes[row], .power = *power});
    for (const auto& [column, shown] : kColumns) {
      plan.settings.emplace_back(table.has(column) ? table.texts(column)[row] : "");
    }
  }
  return plans;
}

/// The properties of a plan that differ between plans: "exact binomial test, one-sided · p₁ = 0.6".
Phrase name_of_plan(const PlannedPoint& plan, const std::vector<PlannedPoint>& all) {
  Phrase name{};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const bool differs = std::any_of(all.begin(), all.end(), [&](const PlannedPoint& other) {
      return other.settings[i] != plan.settings[i];
    });
    if (!differs || plan.settings[i].empty()) continue;
    const Phrase one =
        i == 0 ? words_of_kind(plan.settings[0])
               : phrase("Figures", "%1 = %2").with(kColumns[i].second, plan.settings[i]);
    name = name.empty() ? one : phrase("Figures", "%1 · %2").with(name, one);
  }
  return name;
}

void add_curves(const std::vector<PlannedPoint>& plans, Figure& figure) {
  std::map<std::vector<std::string>, std::size_t> series_of{};
  for (const PlannedPoint& plan : plans) {
    const auto [at, is_new] = series_of.try_emplace(plan.settings, figure.series.size());
    if (is_new) {
      figure.series.push_back(
          {.name = name_of_plan(plan, plans), .style = static_cast<int>(at->second)});
    }
    figure.series[at->second].points.push_back({.x = plan.n, .y = plan.power});
  }
  double least = plans.front().n;
  double most = plans.front().n;
  for (FigureSeries& series : figure.series) {
    std::sort(series.points.begin(), series.points.end(),
              [](const FigurePoint& a, const FigurePoint& b) { return a.x < b.x; });
    std::vector<FigurePlace>& line = series.lines.emplace_back();
    for (const FigurePoint& point : series.points) line.push_back({.x = point.x, .y = point.y});
    least = std::min(least, series.points.front().x);
    most = std::max(most, series.points.back().x);
  }
  if (figure.series.size() == 1) figure.series.front().name = {};
  const double room = most > least ? 0.05 * (most - least) : 1.0;
  figure.x = {.name = phrase("Figures", "planned n"),
              .low = std::max(0.0, least - room),
              .high = most + room};
  figure.y = {.name = phrase("Figures", "power: probability of detecting the effect"),
              .low = 0.0,
              .high = 1.0};
  figure.references.push_back(
      {.at = FigureReference::At::y, .value = kWanted, .label = phrase("Figures", "80 %")});
}

void add_rows_of_plans(const std::vector<PlannedPoint>& plans, Figure& figure) {
  figure.shape = FigureShape::rows;
  FigureSeries points{};
  for (const PlannedPoint& plan : plans) {
    points.points.push_back({.x = plan.power, .y = static_cast<double>(figure.y.places.size())});
    figure.y.places.push_back(phrase("Figures", "%1 · %2 (n = %3)")
                                  .with(plan.id, words_of_kind(plan.settings[0]),
                                        std::to_string(static_cast<long>(plan.n))));
  }
  figure.series.push_back(std::move(points));
  figure.x = {.name = phrase("Figures", "power: probability of detecting the effect"),
              .low = 0.0,
              .high = 1.0};
  figure.references.push_back({.value = kWanted, .label = phrase("Figures", "80 %")});
}

}  // namespace

Figure power_figure(const TidyInput& input, const FoundNumbers& found) {
  Figure figure{
      .name = "power",
      .title = phrase("Figures", "Power of the planned tests"),
      .note = phrase("Figures",
                     "Points are powers at the planned sample sizes, each computed "
                     "separately: between them, the power of exact tests of counts is "
                     "not monotonic. The dashed line is the conventional power of 80 %.")};
  const std::vector<PlannedPoint> plans = planned_in(input, found);
  if (plans.empty()) {
    figure.instead =
        phrase("Figures", "No power was computed for any plan; add a plan to the table.");
    return figure;
  }
  std::map<std::vector<std::string>, std::set<double>> sizes{};
  for (const PlannedPoint& plan : plans) sizes[plan.settings].insert(plan.n);
  const bool has_curve = std::any_of(sizes.begin(), sizes.end(),
                                     [](const auto& one) { return one.second.size() > 1; });
  if (has_curve && sizes.size() <= kMostCurves) {
    add_curves(plans, figure);
  } else {
    add_rows_of_plans(plans, figure);
  }
  return figure;
}

}  // namespace asperity
