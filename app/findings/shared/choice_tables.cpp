// Rows by position from tallies, and rows by item from the log-worths of a family.

#include "app/findings/shared/choice_tables.h"

#include <cstddef>
#include <utility>

#include "analysis/choices/conditional_logit.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/shared/figures/forest_figures.h"
#include "app/findings/shared/figures/scale_figure.h"

namespace asperity {

namespace {

const ResultColumn kLogWorthOfItem{.id = "log_worth",
                                   .heading = phrase("AnalysisWords", "log-worth")};
const ResultColumn kWorthOfItem{.id = "worth", .heading = phrase("AnalysisWords", "worth")};

std::vector<Figure> figures_of_scale(const ResultTable&, const AnalysisOutcome& outcome) {
  const FoundNumbers found(outcome.findings, kWorthScale);
  if (found.empty()) return {};
  const bool of_pairs = !found.all("bt.ability").empty() || found.find("bt.status") != nullptr;
  return {answering(
      "pairs", scale_figure(kWorthScale, of_pairs ? bradley_terry() : plackett_luce(), found))};
}

}  // namespace

std::vector<Figure> figures_of_pairs(const ResultTable& table, const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{share_forest(table)};
  if (table_named(outcome, kWorthScale) == nullptr) {
    for (Figure& figure : figures_of_scale(table, outcome)) figures.push_back(std::move(figure));
  }
  return figures;
}

void add_positions_table(std::span<const Tally> positions, const Phrase& note,
                         AnalysisOutcome& outcome) {
  ShareTable table{kPositions,
                   phrase("Analysis", "Proportion of choices of each position"),
                   note,
                   {columns::kPosition},
                   columns::kChosen,
                   "share_of_position",
                   {}};
  for (std::size_t place = 0; place < positions.size(); ++place) {
    table.rows.push_back({{std::to_string(place + 1)}, positions[place]});
  }
  add_shares(table, outcome).figures = [](const ResultTable& made, const AnalysisOutcome& drawn) {
    return std::vector{
        answering("position", share_forest(made, drawn, {kPersonsByPosition, "position"}))};
  };
}

void add_worth_scale(const WorthScale& scale, std::span<const std::string> items,
                     const FoundNumbers& found, AnalysisOutcome& outcome) {
  const Phrase intervals =
      found.find(scale.no_interval) == nullptr
          ? phrase("Analysis",
                   "95 % CI: t intervals based on CR2 standard errors with the participants as "
                   "clusters and Satterthwaite's degrees of freedom.")
          : phrase("Analysis", "No CI: at least %1 participants are needed; add participants.")
                .with(std::to_string(kFewestClusters));
  ResultTable table{kWorthScale,
                    scale.title,
                    {columns::kItem, kLogWorthOfItem, interval_of(kLogWorthOfItem), kWorthOfItem},
                    scale.note.with(intervals)};
  table.figures = figures_of_scale;
  for (const std::string& item : items) {
    table.add({item, found.cell(scale.log_worth, item), found.interval(scale.log_worth, item),
               found.cell(scale.worth, item)});
  }
  outcome.tables.push_back(std::move(table));
}

}  // namespace asperity
