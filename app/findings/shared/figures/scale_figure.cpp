// Items along a scale, in descending order from the top.

#include "app/findings/shared/figures/scale_figure.h"

#include <algorithm>

#include "app/findings/outcome/finding_parts.h"

namespace asperity {

ScaleChoice bradley_terry() {
  return {.quantity = "bt.ability.sumzero.cluster",
          .otherwise = "bt.firth.ability",
          .status = "bt.status",
          .title = phrase("Figures", "Scale of the items (Bradley–Terry)")};
}

ScaleChoice plackett_luce() {
  return {.quantity = "pl.logworth.sumzero.cluster",
          .status = "pl.status",
          .title = phrase("Figures", "Scale of the items (Plackett–Luce)")};
}

Figure scale_figure(const std::string& name, const ScaleChoice& choice, const FoundNumbers& found) {
  Figure figure{.name = name, .title = choice.title, .shape = FigureShape::rows};
  std::vector<const Finding*> items = found.all(choice.quantity);
  const bool is_over_participants = !items.empty();
  if (items.empty()) items = found.all(choice.otherwise);
  std::erase_if(items, [](const Finding* item) { return !item->value; });
  if (items.empty()) {
    const Finding* status = found.find(choice.status);
    figure.instead =
        status != nullptr
            ? phrase("Figures", "There is no scale: %1.").with(status->status)
            : phrase(
                  "Figures",
                  "There is no scale, because there are no judgements; collect judgements first.");
    return figure;
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const Finding* a, const Finding* b) { return *a->value > *b->value; });
  FigureSeries points{};
  bool has_intervals = false;
  double low = *items.back()->value;
  double high = *items.front()->value;
  for (const Finding* item : items) {
    const std::optional<FigureSpan> interval =
        is_over_participants ? interval_of(*item) : std::nullopt;
    points.points.push_back({.x = *item->value,
                             .y = static_cast<double>(figure.y.places.size()),
                             .x_interval = interval});
    figure.y.places.push_back(item->key.text());
    if (!interval) continue;
    has_intervals = true;
    low = std::min(low, interval->low);
    high = std::max(high, interval->high);
  }
  const double room = high > low ? 0.05 * (high - low) : 0.5;
  figure.x = {
      .name =
          has_intervals
              ? phrase("Figures", "log-worth (centred), with its %1 % CI").with(percent_of(items))
              : phrase("Figures", "log-worth (centred)"),
      .low = low - room,
      .high = high + room};
  if (has_intervals) {
    figure.note =
        phrase("Figures",
               "Points are log-worths; error bars show their t-based CIs with the participants as "
               "clusters. Overlapping CIs are not a test of a difference.");
  } else if (is_over_participants) {
    figure.note = phrase("Figures",
                         "Points are log-worths. There are no CIs, because there are too few "
                         "participants or all of them made the same choices.");
  } else {
    figure.note = phrase("Figures",
                         "Points are log-worths with Firth's bias reduction, relative to the first "
                         "item. There are no CIs over participants.");
  }
  figure.series.push_back(std::move(points));
  return figure;
}

}  // namespace asperity
