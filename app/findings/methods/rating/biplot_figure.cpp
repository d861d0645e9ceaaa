// Items and scales in the plane of the first two principal components.

#include "app/findings/methods/rating/biplot_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

constexpr const char* kFirstComponent = "C1";
constexpr const char* kSecondComponent = "C2";
constexpr double kRoomForLabels = 0.2;  // at both ends, in proportion to the range of the marks
constexpr double kLowestOfWidth = 0.5;  // height in proportion to the width

struct PlacedName {
  std::string name{};
  FigurePlace at{};
  double distance() const { return std::hypot(at.x, at.y); }
};

/// Scores or loadings on the first two components.
std::vector<PlacedName> places_in_plane(const FoundNumbers& found, QuantityName quantity) {
  std::vector<PlacedName> places{};
  for (const Finding* one : found.all(quantity)) {
    if (!one->value || one->key[1] != kFirstComponent) continue;
    const std::string& name = one->key[0];
    const std::optional<double> second = found.value(quantity, {name, kSecondComponent});
    if (second) places.push_back({.name = name, .at = {.x = *one->value, .y = *second}});
  }
  return places;
}

double farthest(const std::vector<PlacedName>& places) {
  double farthest = 0.0;
  for (const PlacedName& place : places) farthest = std::max(farthest, place.distance());
  return farthest;
}

/// The largest round number by which loadings can be multiplied without leaving the range of the
/// scores; at least 1.
double length_of_arrows(double scores, double loadings) {
  double length = 1.0;
  for (const double round : {1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
    if (round * loadings <= scores) length = round;
  }
  return length;
}

/// An axis of this length with the marks in its middle.
FigureAxis axis_of(const FigureSpan& marks, double length) {
  const double middle = 0.5 * (marks.low + marks.high);
  return {.low = middle - 0.5 * length, .high = middle + 0.5 * length};
}

Phrase name_of_component(const FoundNumbers& found, const char* component) {
  const double proportion = found.value("proportion", component).value_or(0.0);
  return phrase("Figures", "%1 (%2 % of the variance)")
      .with(component, fixed(100.0 * proportion, 0));
}

Phrase note_of_biplot(const FoundNumbers& found, double length) {
  const Phrase marks =
      length == 1.0
          ? phrase("Figures",
                   "Points are the standardised scores of the items. Arrows are the loadings of "
                   "the scales: their correlations with the components. As far as the two "
                   "components represent the ratings, an item in the direction of an arrow was "
                   "rated high on that scale.")
          : phrase("Figures",
                   "Points are the standardised scores of the items. Arrows are %1 times the "
                   "loadings of the scales: their correlations with the components. As far as the "
                   "two components represent the ratings, an item in the direction of an arrow was "
                   "rated high on that scale.")
                .with(number_text(length));
  const double retained = found.value("retained").value_or(0.0);
  if (retained < 1.0) {
    return phrase("Figures",
                  "%1 Parallel analysis retains no component: both may be due to chance.")
        .with(marks);
  }
  if (retained < 2.0) {
    return phrase("Figures",
                  "%1 Parallel analysis retains only the first component: the second may be due to "
                  "chance.")
        .with(marks);
  }
  return marks;
}

}  // namespace

Figure biplot_figure(const FoundNumbers& found) {
  Figure figure{.name = "biplot",
                .title = phrase("Figures", "Biplot of the first two principal components"),
                .shape = FigureShape::square};
  std::vector<PlacedName> items = places_in_plane(found, "score");
  const std::vector<PlacedName> scales = places_in_plane(found, "loading");
  if (items.empty() || scales.empty()) {
    const Finding* const none = found.find("eigenvalue");
    figure.instead =
        none != nullptr && !none->status.empty()
            ? phrase("Figures", "There are no components: %1.").with(none->status)
            : phrase("Figures",
                     "There are fewer than two components, and a biplot requires two; add scales.");
    return figure;
  }
  if (!(found.value("eigenvalue", kSecondComponent).value_or(0.0) > 0.0)) {
    figure.instead = phrase("Figures",
                            "The mean ratings vary along one component only, so that there is no "
                            "second axis; add scales or items.");
    return figure;
  }
  // Scores of unit variance: their products with the loadings, over all components, are the standardised ratings.
  const double first_sd = std::sqrt(found.value("eigenvalue", kFirstComponent).value_or(1.0));
  const double second_sd = std::sqrt(*found.value("eigenvalue", kSecondComponent));
  for (PlacedName& item : items) item.at = {item.at.x / first_sd, item.at.y / second_sd};
  const double length = length_of_arrows(farthest(items), farthest(scales));
  figure.note = note_of_biplot(found, length);
  FigureSeries points{.name = phrase("Figures", "items")};
  FigureSpan across{};  // with the origin
  FigureSpan along{};
  const auto hold = [&across, &along](const FigurePlace& place) {
    across = {std::min(across.low, place.x), std::max(across.high, place.x)};
    along = {std::min(along.low, place.y), std::max(along.high, place.y)};
  };
  for (const PlacedName& item : items) {
    hold(item.at);
    points.points.push_back({.x = item.at.x, .y = item.at.y, .label = item.name});
  }
  FigureSeries arrows{
      .name = length == 1.0 ? phrase("Figures", "scales (loadings)")
                            : phrase("Figures", "scales (loadings × %1)").with(number_text(length)),
      .style = 5};
  for (const PlacedName& scale : scales) {
    const FigurePlace to{.x = length * scale.at.x, .y = length * scale.at.y};
    hold(to);
    arrows.arrows.push_back({.to = to, .label = scale.name});
  }
  const double room = 1.0 + 2.0 * kRoomForLabels;
  const double height = room * (along.high - along.low);
  const double width = std::max(room * (across.high - across.low), height);
  figure.x = axis_of(across, width);
  figure.x.name = name_of_component(found, kFirstComponent);
  figure.y = axis_of(along, std::max(height, kLowestOfWidth * width));
  figure.y.name = name_of_component(found, kSecondComponent);
  figure.series.push_back(std::move(points));
  figure.series.push_back(std::move(arrows));
  return figure;
}

}  // namespace asperity
