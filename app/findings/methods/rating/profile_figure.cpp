// The means of several items on several scales, as a profile of each item.

#include "app/findings/methods/rating/profile_figure.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/shared/figures/mean_figures.h"

namespace asperity {

namespace {

/// Styles whose marks are filled; as many have outlined marks.
constexpr std::size_t kFilledStyles = 6;
constexpr std::size_t kMostProfiles = 2 * kFilledStyles;

/// Where there are both ends.
std::optional<FigureSpan> span_of(const std::optional<double>& low,
                                  const std::optional<double>& high) {
  if (!low || !high) return {};
  return FigureSpan{.low = *low, .high = *high};
}

/// A row of the table of means.
struct RatedMean {
  std::string scale{};
  std::string item{};
  std::optional<double> mean{};
  std::optional<FigureSpan> interval{};
  std::int64_t persons = 0;
};

/// What participants saw of a scale.
struct ShownScale {
  std::string name{};
  std::string low_label{};
  std::string high_label{};
  std::optional<FigureSpan> range{};
};

std::vector<RatedMean> means_in(const ResultTable& table) {
  std::vector<RatedMean> means{};
  for (const ResultRow& cells : table.rows) {
    const RowReader row(table, cells);
    const Interval interval = row.interval(columns::kMean);
    means.push_back(
        {.scale = row.text(columns::kScale),
         .item = row.text(columns::kItem),
         .mean = row.number(columns::kMean),
         .interval = span_of(interval.low, interval.high),
         .persons = static_cast<std::int64_t>(row.number(columns::kPersons).value_or(0.0))});
  }
  return means;
}

/// Those that the means are of, in their order.
std::vector<ShownScale> scales_of(const std::vector<RatedMean>& means, const ResultTable* shown) {
  std::vector<ShownScale> scales{};
  for (const RatedMean& mean : means) {
    const bool is_known =
        std::any_of(scales.begin(), scales.end(),
                    [&mean](const ShownScale& scale) { return scale.name == mean.scale; });
    if (!is_known) scales.push_back({.name = mean.scale});
  }
  if (shown == nullptr) return scales;
  for (const ResultRow& cells : shown->rows) {
    const RowReader row(*shown, cells);
    for (ShownScale& scale : scales) {
      if (scale.name != row.text(columns::kScale)) continue;
      scale.low_label = row.text(kLowLabel);
      scale.high_label = row.text(kHighLabel);
      scale.range = span_of(row.number(columns::kMinimum), row.number(columns::kMaximum));
    }
  }
  return scales;
}

/// The ends of each scale; its name as well where several have the same ends, or none.
void label_rows(const std::vector<ShownScale>& scales, FigureAxis& axis) {
  std::set<std::pair<std::string, std::string>> ends{};
  bool has_ends = false;
  for (const ShownScale& scale : scales) {
    ends.emplace(scale.low_label, scale.high_label);
    has_ends = has_ends || !scale.low_label.empty() || !scale.high_label.empty();
  }
  const bool are_distinct = ends.size() == scales.size();
  for (const ShownScale& scale : scales) {
    const bool needs_name = !are_distinct || scale.low_label.empty() || scale.high_label.empty();
    axis.places.push_back(!needs_name ? Phrase(scale.low_label)
                          : scale.low_label.empty()
                              ? Phrase(scale.name)
                              : phrase("Figures", "%1: %2").with(scale.name, scale.low_label));
    if (has_ends) axis.far_places.emplace_back(scale.high_label);
  }
}

bool profile_has_intervals(const std::vector<RatedMean>& means) {
  return std::any_of(means.begin(), means.end(),
                     [](const RatedMean& mean) { return mean.mean && mean.interval; });
}

/// The axis of all rows: their scale where they have the same one, otherwise percentages of each
/// scale's range; without ranges the scores.
enum class ProfileAxis { one_scale, percent_of_range, scores };

ProfileAxis lay_axis(const std::vector<ShownScale>& scales, const std::vector<RatedMean>& means,
                     FigureAxis& axis) {
  axis.name = profile_has_intervals(means) ? phrase("Figures", "mean rating with its 95 % CI")
                                           : phrase("Figures", "mean rating");
  const auto has_range = [](const ShownScale& scale) {
    return scale.range && scale.range->low < scale.range->high;
  };
  if (std::all_of(scales.begin(), scales.end(), has_range)) {
    const FigureSpan first = *scales.front().range;
    const bool is_one =
        std::all_of(scales.begin(), scales.end(), [&first](const ShownScale& scale) {
          return scale.range->low == first.low && scale.range->high == first.high;
        });
    if (!is_one) axis.name = phrase("Figures", "%1, in % of the scale").with(axis.name);
    axis.low = is_one ? first.low : 0.0;
    axis.high = is_one ? first.high : 100.0;
    return is_one ? ProfileAxis::one_scale : ProfileAxis::percent_of_range;
  }
  bool is_first = true;
  for (const RatedMean& mean : means) {
    if (!mean.mean) continue;
    const FigureSpan span = mean.interval.value_or(FigureSpan{*mean.mean, *mean.mean});
    axis.low = is_first ? span.low : std::min(axis.low, span.low);
    axis.high = is_first ? span.high : std::max(axis.high, span.high);
    is_first = false;
  }
  if (!(axis.low < axis.high)) {
    axis.low -= 0.5;
    axis.high += 0.5;
  }
  return ProfileAxis::scores;
}

/// A profile: the means of one item, joined where they follow each other.
FigureSeries profile_of(const std::string& item, std::size_t number, double aside,
                        const std::vector<ShownScale>& scales, const std::vector<RatedMean>& means,
                        ProfileAxis drawn_on) {
  FigureSeries series{.name = words_of_condition(item),
                      .style = static_cast<int>(number % kFilledStyles),
                      .hollow = number >= kFilledStyles};
  bool is_joined = false;
  for (std::size_t row = 0; row < scales.size(); ++row) {
    const auto mean = std::find_if(means.begin(), means.end(), [&](const RatedMean& one) {
      return one.scale == scales[row].name && one.item == item && one.mean;
    });
    if (mean == means.end()) {
      is_joined = false;
      continue;
    }
    const auto place = [&](double score) {
      if (drawn_on != ProfileAxis::percent_of_range) return score;
      const FigureSpan& range = *scales[row].range;
      return 100.0 * (score - range.low) / (range.high - range.low);
    };
    FigurePoint point{.x = place(*mean->mean), .y = static_cast<double>(row) + aside};
    if (mean->interval) {
      point.x_interval = {.low = place(mean->interval->low), .high = place(mean->interval->high)};
    }
    if (!is_joined) series.lines.emplace_back();
    is_joined = true;
    series.lines.back().push_back({.x = point.x, .y = point.y});
    series.points.push_back(point);
  }
  return series;
}

/// "12", or "10 to 12" where the scales differ.
Phrase persons_of(const std::vector<RatedMean>& means) {
  std::int64_t fewest = 0;
  std::int64_t most = 0;
  for (const RatedMean& mean : means) {
    if (!mean.mean) continue;
    fewest = most == 0 ? mean.persons : std::min(fewest, mean.persons);
    most = std::max(most, mean.persons);
  }
  if (fewest == most) return std::to_string(most);
  return phrase("Figures", "%1 to %2").with(std::to_string(fewest), std::to_string(most));
}

Phrase note_of_profile(const std::vector<RatedMean>& means, ProfileAxis drawn_on) {
  const Phrase marks =
      (profile_has_intervals(means)
           ? phrase("Figures",
                    "Points are means of the participants' own means (n = %1), shifted within "
                    "their row; error bars show their t-based 95 % CIs. Lines guide the eye.")
           : phrase("Figures",
                    "Points are means of the participants' own means (n = %1), shifted within "
                    "their row; there are no CIs. Lines guide the eye."))
          .with(persons_of(means));
  if (drawn_on != ProfileAxis::percent_of_range) return marks;
  return phrase(
             "Figures",
             "%1 The scales have different ranges: each row is drawn over the range of its scale.")
      .with(marks);
}

bool continues_beyond(const Figure& figure) {
  for (const FigureSeries& series : figure.series) {
    for (const FigurePoint& point : series.points) {
      if (point.x_interval &&
          (point.x_interval->low < figure.x.low || point.x_interval->high > figure.x.high)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

Figure profile_figure(const ResultTable& ratings, const ResultTable* shown) {
  Figure figure{.name = "profile",
                .title = phrase("Figures", "Profiles of the items: mean ratings on each scale"),
                .shape = FigureShape::rows};
  const std::vector<RatedMean> means = means_in(ratings);
  const bool has_mean = std::any_of(means.begin(), means.end(),
                                    [](const RatedMean& mean) { return mean.mean.has_value(); });
  if (!has_mean) {
    figure.instead = phrase(
        "Figures",
        "No participant rated every item, so that there are no means; add the missing ratings.");
    return figure;
  }
  std::vector<std::string> items{};
  for (const RatedMean& mean : means) {
    if (std::find(items.begin(), items.end(), mean.item) == items.end()) items.push_back(mean.item);
  }
  if (items.size() > kMostProfiles) {
    figure.instead = phrase("Figures",
                            "The profiles of %1 items could not be distinguished in one figure (at "
                            "most %2); the table has their means.")
                         .with(std::to_string(items.size()), std::to_string(kMostProfiles));
    return figure;
  }
  const std::vector<ShownScale> scales = scales_of(means, shown);
  label_rows(scales, figure.y);
  const ProfileAxis drawn_on = lay_axis(scales, means, figure.x);
  figure.note = note_of_profile(means, drawn_on);
  figure.marks_per_row = items.size();
  const auto profiles = static_cast<double>(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double aside =
        (static_cast<double>(i) - 0.5 * (profiles - 1.0)) / (profiles + kRoomBetweenRows);
    figure.series.push_back(profile_of(items[i], i, aside, scales, means, drawn_on));
  }
  std::erase_if(figure.series, [](const FigureSeries& series) { return series.points.empty(); });
  if (continues_beyond(figure)) {
    figure.note =
        phrase("Figures", "%1 An arrow marks a CI that continues beyond the end of the scale.")
            .with(figure.note);
  }
  return figure;
}

std::vector<Figure> rating_figures(const ResultTable& ratings, const AnalysisOutcome& outcome) {
  std::string question{};
  for (const AnsweredQuestion& asked : outcome.questions) {
    if (asked.table == ratings.name) question = asked.name;
  }
  std::set<std::string> scales{};
  for (const ResultRow& row : ratings.rows) {
    scales.insert(RowReader(ratings, row).text(columns::kScale));
  }
  if (scales.size() > 1) {
    return {answering(question, profile_figure(ratings, table_named(outcome, kScales)))};
  }
  std::vector<Finding> means{};
  for (const Finding* const mean : FoundNumbers(outcome.findings, ratings.name).all("mean.score")) {
    means.push_back(*mean);
    means.back().key = mean->key.without_first();  // the scale
  }
  return {answering(question, rating_figure(FoundNumbers(means)))};
}

}  // namespace asperity
