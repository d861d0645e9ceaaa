// Rows by position from tallies, and rows by item from the log-worths of a family.

#include "app/findings/shared/choice_tables.h"

#include <cstddef>
#include <utility>

#include "analysis/choices/conditional_logit.h"

namespace asperity {

void add_positions_table(std::span<const Tally> positions, const Phrase& note,
                         AnalysisOutcome& outcome) {
  ShareTable table{"positions", phrase("Analysis", "Proportion of choices of each position"),
                   note,        {"position"},
                   "chosen",    "share_of_position",
                   {}};
  for (std::size_t place = 0; place < positions.size(); ++place) {
    table.rows.push_back({{std::to_string(place + 1)}, positions[place]});
  }
  add_shares(table, outcome);
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
  NamedTable table{"scale",
                   scale.title,
                   {{"item", "log_worth", "log_worth_low", "log_worth_high", "worth"}, {}},
                   scale.note.with(intervals)};
  for (const std::string& item : items) {
    const auto [low, high] = found.interval(scale.log_worth, item);
    table.table.rows.push_back(
        {item, found.cell(scale.log_worth, item), low, high, found.cell(scale.worth, item)});
  }
  outcome.tables.push_back(std::move(table));
}

}  // namespace asperity
