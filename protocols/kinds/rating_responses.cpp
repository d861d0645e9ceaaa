#include "protocols/kinds/rating_responses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr const char* kItemDifference = "difference";
constexpr const char* kScaleUnit = "unit of the scale";

/// Whether the scale accompanies a question of another kind, which has correct responses.
bool accompanies_correct_responses(const TabulatedQuestion& asked) {
  const ExperimentKind& of_block = kind_of(asked.block);
  return !std::holds_alternative<ScaleForm>(of_block.form) && of_block.has_correct_responses;
}

/// The items, or where there is one the combinations of levels of the factors.
bool has_several_items(const TabulatedQuestion& asked) {
  return asked.block.presented.size() == 1 && (asked.items.size() > 1 || !asked.factors.empty());
}

struct RatedItem {
  std::string name{};
  double place = 0.0;
};

RatedItem rated_item_of(const TabulatedTrial& trial) {
  const TabulatedQuestion& asked = trial.asked;
  if (asked.items.size() > 1) {
    const std::string& item = trial.trial.presentations.front().item;
    return {item, place_among(asked.items, item)};
  }
  // The first factor varies slowest.
  RatedItem item{};
  std::size_t index = 0;
  std::size_t count = 1;
  for (const auto& [factor, levels] : asked.factors) {
    const std::string level = text_of(trial.trial.factors.at(factor));
    item.name += level + '|';
    const auto at = std::find(levels.begin(), levels.end(), level) - levels.begin();
    index = index * levels.size() + static_cast<std::size_t>(at);
    count *= levels.size();
  }
  item.place = static_cast<double>(index) / static_cast<double>(count - 1) - 0.5;
  return item;
}

std::vector<ResponseParameter> parameters_of_rating(const TabulatedQuestion& asked) {
  const auto& form = std::get<ScaleForm>(asked.question.form);
  const double range = form.maximum - form.minimum;
  ParameterList list(asked);
  if (has_several_items(asked)) {
    list.effect({.effect = {.name = kItemDifference,
                            .unit = kScaleUnit,
                            .meaning = "mean rating of the last item minus that of the first; the "
                                       "items are equally spaced"},
                 .tests = {"ratings", "rated_pairs", "rating_model"},
                 .sd_unit = kScaleUnit,
                 .sd_meaning = "SD over participants of the difference between any two items",
                 .usual_sd = 0.15 * range});
  }
  if (accompanies_correct_responses(asked)) {
    list.effect({.effect = {.name = "correct",
                            .unit = kScaleUnit,
                            .meaning = "mean rating with correct minus that with incorrect "
                                       "responses"},
                 .tests = {"accompanying_scales"},
                 .sd_unit = kScaleUnit,
                 .sd_meaning = "SD over participants of this difference",
                 .usual_sd = 0.1 * range});
  }
  list.assumed({.name = "level",
                .unit = kScaleUnit,
                .meaning = "mean rating of all items",
                .value = form.minimum + 0.5 * range});
  list.assumed({.name = "level_sd",
                .range = ParameterRange::not_negative,
                .unit = kScaleUnit,
                .meaning = "SD over participants of the mean rating of all items",
                .value = 0.1 * range});
  list.assumed({.name = "noise_sd",
                .range = ParameterRange::not_negative,
                .unit = kScaleUnit,
                .meaning = "SD of the ratings of one participant for one item",
                .value = 0.15 * range});
  list.lapse();
  return list.take();
}

Answer rate_surface(const TabulatedTrial& trial) {
  const auto& form = std::get<ScaleForm>(trial.question.form);
  Random noise = trial.of_response.split("rating");
  if (trial.lapses()) {
    const auto points = static_cast<std::uint64_t>(form.steps()) + 1;
    return ScalePoint{static_cast<int>(noise.below(points))};
  }
  double rating = trial.own("level") + trial.values.at("noise_sd") * noise.normal();
  if (has_several_items(trial.asked)) {
    const RatedItem item = rated_item_of(trial);
    const double sd = trial.values.at(std::string(kItemDifference) + "_sd");
    rating += trial.values.at(kItemDifference) * item.place +
              trial.own_of(kItemDifference, item.name, sd / std::numbers::sqrt2);
  }
  if (trial.is_correct && accompanies_correct_responses(trial.asked)) {
    rating += (*trial.is_correct ? 0.5 : -0.5) * trial.own("correct");
  }
  const double share =
      std::clamp((rating - form.minimum) / (form.maximum - form.minimum), 0.0, 1.0);
  return ScalePoint{static_cast<int>(std::lround(share * form.steps()))};
}

}  // namespace

const ResponseTable& rating_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_rating,
                                        .respond = rate_surface};
  return kTable;
}

}  // namespace asperity
