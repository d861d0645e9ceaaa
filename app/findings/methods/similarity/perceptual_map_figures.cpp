// Figures of rated dissimilarities: configuration with ellipses, Shepard diagram, stress by dimensions, and weights of
// participants.

#include "app/findings/methods/similarity/perceptual_map_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/similarity/similarity_configuration.h"
#include "app/findings/outcome/cell_words.h"

namespace asperity {

namespace {

/// Both axes with the same units and some room for labels, so that all of these places are within them.
class MapAxes {
 public:
  void hold(const FigurePlace& place) {
    x_.low = has_any_ ? std::min(x_.low, place.x) : place.x;
    x_.high = has_any_ ? std::max(x_.high, place.x) : place.x;
    y_.low = has_any_ ? std::min(y_.low, place.y) : place.y;
    y_.high = has_any_ ? std::max(y_.high, place.y) : place.y;
    has_any_ = true;
  }
  void set(Figure& figure) const {
    constexpr double kRoom = 1.25;
    constexpr double kSmallest = 1e-9;
    const double reach =
        kRoom * std::max({0.5 * (x_.high - x_.low), 0.5 * (y_.high - y_.low), kSmallest});
    const double middle_x = 0.5 * (x_.low + x_.high);
    const double middle_y = 0.5 * (y_.low + y_.high);
    figure.x.low = middle_x - reach;
    figure.x.high = middle_x + reach;
    figure.y.low = middle_y - reach;
    figure.y.high = middle_y + reach;
  }

 private:
  FigureSpan x_{};
  FigureSpan y_{};
  bool has_any_ = false;
};

struct PlacedLabel {
  std::string name{};
  FigurePlace at{};
};

/// The findings of a quantity in the dimensions 1 and 2, the last names of the keys.
std::vector<PlacedLabel> labelled_places(const FoundNumbers& found, QuantityName quantity) {
  std::vector<PlacedLabel> places{};
  for (const Finding* const one : found.all(quantity)) {
    if (!one->value || one->key[1] != "1") continue;
    const std::string& name = one->key[0];
    if (const auto second = found.value(quantity, {name, "2"}))
      places.push_back({.name = name, .at = {.x = *one->value, .y = *second}});
  }
  return places;
}

std::vector<FigurePlace> ellipse(const FigurePlace& middle, double major, double minor,
                                 double angle_rad) {
  constexpr int kPlaces = 48;
  std::vector<FigurePlace> line{};
  for (int i = 0; i <= kPlaces; ++i) {
    const double t = 2.0 * std::numbers::pi * (i % kPlaces) / kPlaces;
    const double along = major * std::cos(t);
    const double across = minor * std::sin(t);
    line.push_back({.x = middle.x + along * std::cos(angle_rad) - across * std::sin(angle_rad),
                    .y = middle.y + along * std::sin(angle_rad) + across * std::cos(angle_rad)});
  }
  return line;
}

Phrase why_no_configuration(const FoundNumbers& found) {
  const Finding* const stress = found.find("stress.ordinal");
  return stress != nullptr && !stress->word.empty()
             ? phrase("Figures", "There is no configuration: %1.")
                   .with(words_of_status(stress->word))
             : phrase("Figures",
                      "There are no ratings from which to make a configuration; collect "
                      "responses first.");
}

}  // namespace

Figure configuration_figure(const FoundNumbers& found) {
  Figure figure{.name = "configuration",
                .title = is_metric(found)
                             ? phrase("Figures", "Configuration of the items (metric MDS)")
                             : phrase("Figures", "Configuration of the items (non-metric MDS)"),
                .shape = FigureShape::square};
  const std::vector<PlacedLabel> items = labelled_places(found, "position");
  if (items.empty()) {
    figure.instead = why_no_configuration(found);
    return figure;
  }
  const double dimensions = found.value("dimensions").value_or(2.0);
  const double stress = stress_of_configuration(found).value_or(0.0);
  MapAxes axes{};
  FigureSeries points{.name = phrase("Figures", "items")};
  FigureSeries regions{};
  for (const PlacedLabel& item : items) {
    axes.hold(item.at);
    points.points.push_back({.x = item.at.x, .y = item.at.y, .label = item.name});
    const auto major = found.value("region.major", item.name);
    const auto minor = found.value("region.minor", item.name);
    const auto angle_rad = found.value("region.angle", item.name);
    if (!major || !minor || !angle_rad) continue;
    regions.lines.push_back(ellipse(item.at, *major, *minor, *angle_rad));
    for (const FigurePlace& place : regions.lines.back()) axes.hold(place);
  }
  constexpr double kShown = 2.0;
  const Phrase fit =
      dimensions > kShown
          ? phrase(
                "Figures",
                "The first two of %1 dimensions; directions cannot be interpreted. Stress-1 in %1 "
                "dimensions: %2. Distances in all dimensions correspond to the order of the mean "
                "dissimilarities.")
                .with(fixed(dimensions, 0), fixed(stress, 3))
          : phrase(
                "Figures",
                "Distances correspond to the order of the mean dissimilarities; directions cannot "
                "be interpreted. Stress-1 in %1 dimensions: %2.")
                .with(fixed(dimensions, 0), fixed(stress, 3));
  figure.note = regions.lines.empty()
                    ? fit
                    : phrase("Figures",
                             "%1 Ellipses: 95 % of the positions in a bootstrap over participants.")
                          .with(fit);
  figure.x.name = phrase("Figures", "first MDS dimension");
  figure.y.name = phrase("Figures", "second dimension");
  axes.set(figure);
  figure.series.push_back(std::move(points));
  if (!regions.lines.empty()) figure.series.push_back(std::move(regions));
  return figure;
}

Figure shepard_figure(const FoundNumbers& found) {
  Figure figure{.name = "shepard_diagram",
                .title = phrase("Figures", "Shepard diagram"),
                .note = phrase("Figures",
                               "A point per pair: its distance in the configuration by its mean "
                               "dissimilarity. Line: disparities, the isotonic regression of the "
                               "distances; stress is their deviation from the points.")};
  struct Pair {
    double dissimilarity = 0.0;
    double distance = 0.0;
    double disparity = 0.0;
  };
  std::vector<Pair> pairs{};
  for (const Finding* const one : found.all("distance")) {
    const auto dissimilarity = found.value("dissimilarity", one->key);
    const auto disparity = found.value("disparity", one->key);
    if (one->value && dissimilarity && disparity)
      pairs.push_back({*dissimilarity, *one->value, *disparity});
  }
  if (pairs.empty()) {
    figure.instead = why_no_configuration(found);
    return figure;
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::pair(a.dissimilarity, a.disparity) < std::pair(b.dissimilarity, b.disparity);
  });
  FigureSeries points{.name = phrase("Figures", "pairs")};
  FigureSeries line{.name = phrase("Figures", "disparities"), .style = 1};
  line.lines.emplace_back();
  double farthest = 0.0;
  for (const Pair& pair : pairs) {
    points.points.push_back({.x = pair.dissimilarity, .y = pair.distance});
    line.lines.front().push_back({.x = pair.dissimilarity, .y = pair.disparity});
    farthest = std::max({farthest, pair.distance, pair.disparity});
  }
  constexpr double kRoom = 1.05;
  const double highest = std::max(pairs.back().dissimilarity, 1e-9);
  figure.x = {.name = phrase("Figures", "mean dissimilarity"), .low = 0.0, .high = kRoom * highest};
  figure.y = {.name = phrase("Figures", "distance in the configuration"),
              .low = 0.0,
              .high = kRoom * std::max(farthest, 1e-9)};
  figure.series.push_back(std::move(points));
  figure.series.push_back(std::move(line));
  return figure;
}

Figure stress_figure(const FoundNumbers& found) {
  Figure figure{.name = "stress_by_dimensions",
                .title = phrase("Figures", "Stress by the number of dimensions")};
  const auto chosen = found.value("cv.chosen");
  figure.note = chosen ? phrase("Figures",
                                "Kruskal’s stress-1. Cross-validation over participants chooses "
                                "the dimensions: %1.")
                             .with(fixed(*chosen, 0))
                       : phrase("Figures", "Kruskal’s stress-1.");
  struct Scaling {
    QuantityName quantity{};
    Phrase name{};
  };
  double highest = 0.0;
  std::size_t most = 0;
  int style = 0;
  for (const Scaling& level :
       {Scaling{"stress.ordinal", phrase("Figures", "non-metric scaling")},
        Scaling{"stress.ratio", phrase("Figures", "metric (ratio) scaling")}}) {
    FigureSeries series{.name = level.name, .style = style++};
    series.lines.emplace_back();
    for (const Finding* const one : found.all(level.quantity)) {
      if (!one->value) continue;
      const auto dimension = static_cast<double>(series.points.size() + 1);
      series.points.push_back({.x = dimension, .y = *one->value});
      series.lines.front().push_back({.x = dimension, .y = *one->value});
      highest = std::max(highest, *one->value);
    }
    most = std::max(most, series.points.size());
    figure.series.push_back(std::move(series));
  }
  if (most == 0) {
    figure.series.clear();
    figure.instead = why_no_configuration(found);
    return figure;
  }
  // A shorter axis would have ticks at halves.
  constexpr double kLeastEnd = 5.5;
  figure.x = {.name = phrase("Figures", "number of dimensions"),
              .low = 0.0,
              .high = std::max(static_cast<double>(most) + 0.5, kLeastEnd)};
  figure.y = {
      .name = phrase("Figures", "stress-1"), .low = 0.0, .high = 1.1 * std::max(highest, 0.01)};
  return figure;
}

Figure weights_figure(const FoundNumbers& found) {
  Figure figure{
      .name = "weights_of_participants",
      .title = phrase("Figures", "Weights of the dimensions for each participant (INDSCAL)"),
      .note = phrase("Figures",
                     "The farther a participant is from the origin, the better the model "
                     "fits; the direction is the relative weight of the two dimensions."),
      .shape = FigureShape::square};
  const std::vector<PlacedLabel> people = labelled_places(found, "indscal.weight");
  if (people.empty()) {
    const Finding* const fit = found.find("indscal.fit.mean");
    figure.instead = fit != nullptr && !fit->word.empty()
                         ? phrase("Figures",
                                  "Weights require two participants who rated every pair, with "
                                  "ratings that vary; collect more responses.")
                         : why_no_configuration(found);
    return figure;
  }
  MapAxes axes{};
  axes.hold({});
  FigureSeries points{};
  for (const PlacedLabel& person : people) {
    axes.hold(person.at);
    points.points.push_back({.x = person.at.x, .y = person.at.y, .label = person.name});
  }
  axes.set(figure);
  figure.x.name = phrase("Figures", "weight of the first INDSCAL dimension");
  figure.y.name = phrase("Figures", "weight of the second");
  figure.series.push_back(std::move(points));
  return figure;
}

}  // namespace asperity
