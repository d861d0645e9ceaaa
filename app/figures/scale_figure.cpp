// Items along a scale, the greatest on top.

#include <algorithm>

#include "app/figures/figure_kinds.h"

namespace asperity {

Figure scale_figure(const std::string& name, const ScaleChoice& choice, const FoundNumbers& found) {
  Figure figure{.name = name,
                .title = choice.title,
                .note = phrase("Figures",
                               "Points are log-worths (centred), bars their CIs. Overlapping CIs "
                               "are not a test of a difference."),
                .shape = FigureShape::rows};
  std::vector<const Finding*> items{};
  for (const std::string& quantity : choice.quantities) {
    if (items.empty()) items = found.all(quantity);
  }
  std::erase_if(items, [](const Finding* item) { return !item->value; });
  if (items.empty()) {
    const Finding* status = found.find(choice.status);
    figure.instead = status != nullptr
                         ? phrase("Figures", "There is no scale: %1.").with(status->status)
                         : phrase("Figures", "There is no scale: nothing was judged.");
    return figure;
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const Finding* a, const Finding* b) { return *a->value > *b->value; });
  FigureSeries points{};
  double low = *items.back()->value;
  double high = *items.front()->value;
  for (const Finding* item : items) {
    const std::optional<FigureSpan> interval = interval_of(*item);
    points.points.push_back({.x = *item->value,
                             .y = static_cast<double>(figure.y.places.size()),
                             .x_interval = interval});
    figure.y.places.push_back(item->key);
    if (!interval) continue;
    low = std::min(low, interval->low);
    high = std::max(high, interval->high);
  }
  const double room = high > low ? 0.05 * (high - low) : 0.5;
  figure.x = {
      .name = choice.axis.filled({percent_of(items)}), .low = low - room, .high = high + room};
  figure.series.push_back(std::move(points));
  return figure;
}

}  // namespace asperity
