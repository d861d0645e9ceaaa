// Draws the surface with the greatest utility plus Gumbel noise, where the first has an order effect.

#include "protocols/kinds/choice_responses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asperity {

namespace {

constexpr const char* kTarget = "target";
constexpr const char* kDifference = "difference";

/// The declared target, if the block presents it.
bool is_about_target(const TabulatedQuestion& asked) {
  const auto& target = asked.protocol.analysis.target;
  return target && std::find(asked.items.begin(), asked.items.end(), *target) != asked.items.end();
}

void add_choice_parameters(const TabulatedQuestion& asked, ParameterList& list) {
  if (is_about_target(asked)) {
    list.effect({.effect = {.name = kTarget,
                            .unit = "log-odds",
                            .meaning = phrase("Responses",
                                              "natural log-odds that the target %1 is chosen "
                                              "rather than any one other item")
                                           .with(quoted_name(*asked.protocol.analysis.target))},
                 .tests = {"target_pairs", "pairs", "preference"},
                 .compared_in = {kGroupsTest, "textures"},
                 .sd_unit = "log-odds",
                 .sd_meaning = phrase("Responses",
                                      "SD over participants of the log-odds between any two items"),
                 .usual_sd = 1.0});
    if (const auto* const groups = groups_in(asked)) {
      const auto& [factor, levels] = *groups;
      list.effect_of_groups(
          {.name = difference_between(factor),
           .unit = "log-odds",
           .meaning = phrase("Responses",
                             "natural log-odds of the target in the group %1 minus those in %2")
                          .with(quoted_name(levels.back()), quoted_name(levels.front()))});
    }
  } else {
    list.effect(
        {.effect = {.name = kDifference,
                    .unit = "log-odds",
                    .meaning = text_of(
                        {.of_ends = phrase("Responses",
                                           "natural log-odds of a choice of %1 rather than %2")},
                        asked.items)},
         .tests = {"pairs", "preference"},
         .sd_unit = "log-odds",
         .sd_meaning =
             phrase("Responses", "SD over participants of the log-odds between any two items"),
         .usual_sd = 1.0});
  }
  list.effect(
      {.effect = {.name = "order",
                  .unit = "log-odds",
                  .meaning =
                      phrase("Responses",
                             "natural log-odds in favour of the surface that is presented first, "
                             "between surfaces that are otherwise equally preferred")},
       .tests = {"position"},
       .sd_unit = "log-odds",
       .sd_meaning = phrase("Responses",
                            "SD over participants of the log-odds in favour of the first surface"),
       .usual_sd = 0.3});
  if (asked.question.own_as<PairQuestion>() != nullptr) {
    list.assumed({.name = "tie_within",
                  .range = ParameterRange::not_negative,
                  .unit = "log-odds",
                  .meaning = phrase(
                      "Responses", "difference of the utilities below which the response is a tie"),
                  .value = 0.3});
  }
  list.lapse();
}

std::vector<ResponseParameter> parameters_of_choice(const TabulatedQuestion& asked) {
  ParameterList list(asked);
  add_choice_parameters(asked, list);
  return list.take();
}

double utility_of_item(const TabulatedTrial& trial, const std::string& item) {
  const bool is_of_target = is_about_target(trial.asked);
  const char* const effect = is_of_target ? kTarget : kDifference;
  const double place = !is_of_target ? place_among(trial.asked.items, item)
                       : item == trial.asked.protocol.analysis.target ? 1.0
                                                                      : 0.0;
  const double sd = trial.values.at(std::string(effect) + "_sd");
  double mean = trial.values.at(effect);
  const auto* const groups = is_of_target ? groups_in(trial.asked) : nullptr;
  if (groups != nullptr) {
    mean += trial.values.at(difference_between(groups->first)) * trial.place_of(groups->first);
  }
  return mean * place + trial.own_of(effect, item, sd / std::numbers::sqrt2);
}

Answer choose_surface(const TabulatedTrial& trial) {
  Random noise = trial.of_response.split("choice");
  const auto& surfaces = trial.trial.presentations;
  if (trial.lapses()) return ChosenOption{static_cast<std::size_t>(noise.below(surfaces.size()))};
  const double order = trial.own("order");
  std::vector<double> utilities{};
  for (const PlannedPresentation& surface : surfaces) {
    utilities.push_back(utility_of_item(trial, surface.item) + (utilities.empty() ? order : 0.0) +
                        gumbel(noise));
  }
  const bool can_tie =
      trial.asked.question.own_as<PairQuestion>() != nullptr && surfaces.size() == 2;
  if (can_tie && std::abs(utilities[0] - utilities[1]) < trial.values.at("tie_within")) {
    return ChosenOption{surfaces.size()};  // the option after the surfaces
  }
  const auto greatest = std::max_element(utilities.begin(), utilities.end());
  return ChosenOption{static_cast<std::size_t>(greatest - utilities.begin())};
}

}  // namespace

const ResponseTable& selection_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_choice,
                                        .respond = choose_surface};
  return kTable;
}

const ResponseTable& paired_comparison_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_choice,
                                        .respond = choose_surface};
  return kTable;
}

}  // namespace asperity
