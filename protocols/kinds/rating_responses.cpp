// Draws a point about the mean of the item, with differences between items, factors and participants.

#include "protocols/kinds/rating_responses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr const char* kItemDifference = "difference";

/// Whether the scale accompanies a question of another kind.
bool accompanies(const TabulatedQuestion& asked) {
  return !std::holds_alternative<ScaleForm>(kind_of(asked.block).form);
}

bool accompanies_correct_responses(const TabulatedQuestion& asked) {
  return accompanies(asked) && kind_of(asked.block).correct_of != nullptr;
}

/// Whether the levels of a factor determine the surface of the block.
bool determines_surface(const TabulatedQuestion& asked, const std::string& factor) {
  const Protocol::Presented& presented = asked.block.presented.front();
  if (presented.with.contains(factor)) return false;
  const StimulusTemplate& stimulus = asked.protocol.stimuli.at(presented.stimulus);
  const auto is_of_factor = [&factor](const auto& binding) { return binding.factor == factor; };
  return is_of_factor(stimulus.model) || is_of_factor(stimulus.texture) ||
         is_of_factor(stimulus.surface) || is_of_factor(stimulus.tool) ||
         std::any_of(stimulus.parameters.begin(), stimulus.parameters.end(),
                     [&](const auto& each) { return is_of_factor(each.second); });
}

/// The factors of the surface with their levels, and the varied parameter with its values. Ratings are averaged over other factors,
/// such as a condition or the group of the participant.
std::vector<std::pair<std::string, std::vector<std::string>>> rated_factors(
    const TabulatedQuestion& asked) {
  auto factors = asked.factors;
  std::erase_if(factors,
                [&asked](const auto& each) { return !determines_surface(asked, each.first); });
  if (asked.values.size() < 2) return factors;
  std::vector<std::string> values{};
  for (const double value : asked.values) values.push_back(text_of(Level{value}));
  factors.emplace_back(asked.block.vary->factor, std::move(values));
  return factors;
}

/// Whether ratings are compared between items: the surfaces, or where they all count as one item the combinations of levels of
/// the factors that determine them. Scales that accompany another question are only compared if the protocol has no others.
bool has_several_items(const TabulatedQuestion& asked) {
  const auto& blocks = asked.protocol.blocks;
  const bool is_compared =
      !accompanies(asked) || std::none_of(blocks.begin(), blocks.end(), [](const auto& each) {
        return each.second.phase == Phase::main &&
               std::holds_alternative<ScaleForm>(kind_of(each.second).form);
      });
  return is_compared && asked.block.presented.size() == 1 &&
         (asked.items.size() > 1 || !rated_factors(asked).empty());
}

/// The names of what is rated, in the order of `difference`: the items, or the combinations of levels.
std::vector<std::string> rated_names(const TabulatedQuestion& asked) {
  if (asked.items.size() > 1) return asked.items;
  std::vector<std::string> names{""};
  for (const auto& [factor, levels] : rated_factors(asked)) {
    std::vector<std::string> longer{};
    for (const std::string& name : names) {
      for (const std::string& level : levels) {
        longer.push_back(name.empty() ? level : name + ", " + level);
      }
    }
    names = std::move(longer);
  }
  return names;
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
  for (const auto& [factor, levels] : rated_factors(asked)) {
    count *= levels.size();
    index *= levels.size();
    const auto own = trial.trial.factors.find(factor);
    if (own == trial.trial.factors.end()) continue;
    const std::string level = text_of(own->second);
    item.name += level + '|';
    const auto place = std::find(levels.begin(), levels.end(), level);
    if (place != levels.end()) index += static_cast<std::size_t>(place - levels.begin());
  }
  item.place = static_cast<double>(index) / static_cast<double>(count - 1) - 0.5;
  return item;
}

std::vector<ResponseParameter> parameters_of_rating(const TabulatedQuestion& asked) {
  const auto& form = std::get<ScaleForm>(asked.question.form);
  const double range = form.maximum - form.minimum;
  const Phrase on_scale = scale_text(form);
  ParameterList list(asked);
  if (has_several_items(asked)) {
    list.effect(
        {.effect = {.name = kItemDifference,
                    .unit = kScaleUnits,
                    .meaning = text_of(
                        {.of_ends = phrase("Responses", "mean rating of %1 minus that of %2, %3"),
                         .details = on_scale},
                        rated_names(asked))},
         .tests = {"ratings", "rated_pairs", "rating_model"},
         .sd_unit = kScaleUnits,
         .sd_meaning =
             phrase("Responses", "SD over participants of the difference between any two items"),
         .usual_sd = 0.15 * range});
  }
  if (accompanies_correct_responses(asked)) {
    list.effect({.effect = {.name = "correct",
                            .unit = kScaleUnits,
                            .meaning = phrase("Responses",
                                              "mean rating of trials with a correct response minus "
                                              "that of trials with an incorrect one, %1")
                                           .with(on_scale)},
                 .tests = {"accompanying_scales"},
                 .sd_unit = kScaleUnits,
                 .sd_meaning = phrase("Responses", "SD over participants of this difference"),
                 .usual_sd = 0.1 * range});
  }
  if (const auto* const groups = groups_in(asked)) {
    const auto& [factor, levels] = *groups;
    list.effect_of_groups(
        {.name = difference_between(factor),
         .unit = kScaleUnits,
         .meaning =
             phrase("Responses", "mean rating of all items in the group %1 minus that in %2, %3")
                 .with(quoted_name(levels.back()), quoted_name(levels.front()), on_scale)});
  }
  list.scale(range,
             {.meaning = phrase("Responses", "mean rating of all items, %1").with(on_scale),
              .value = form.minimum + 0.5 * range},
             phrase("Responses", "SD over participants of the mean rating of all items"),
             phrase("Responses", "SD of the ratings of one participant for one item"));
  list.varies_within_groups("level_sd");
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
  if (const auto* const groups = groups_in(trial.asked)) {
    rating += trial.values.at(difference_between(groups->first)) * trial.place_of(groups->first);
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
