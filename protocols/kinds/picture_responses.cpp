// Draws impressions of all pictures, and takes the best option or the best whole assignment.

#include "protocols/kinds/picture_responses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace asperity {

namespace {

constexpr const char* kSensitivity = "sensitivity";

std::string ratio_of_groups(const std::string& factor) { return factor + ".ratio"; }

void add_sensitivity(const TabulatedQuestion& asked, std::vector<std::string> tests,
                     ParameterList& list) {
  list.effect(
      {.effect = {.name = kSensitivity,
                  .range = ParameterRange::not_negative,
                  .unit = "d′",
                  .meaning = phrase("Responses",
                                    "d′ of the median participant: how far the picture of the "
                                    "texture felt stands out")},
       .tests = std::move(tests),
       .compared_in = {kGroupsTest, "sexes"},
       .sd_meaning = phrase("Responses", "SD over participants of the natural logarithm of d′"),
       .usual_sd = 0.5});
  if (const auto* const groups = groups_in(asked)) {
    const auto& [factor, levels] = *groups;
    list.effect_of_groups(
        {.name = ratio_of_groups(factor),
         .range = ParameterRange::positive,
         .unit = "ratio",
         .meaning = phrase("Responses", "d′ of the group %1 divided by that of %2")
                        .with(quoted_name(levels.back()), quoted_name(levels.front())),
         .null_value = 1.0});
  }
  list.assumed({.name = "texture_sd",
                .range = ParameterRange::not_negative,
                .meaning = phrase("Responses", "SD over textures of the natural logarithm of d′"),
                .value = 0.3});
}

std::vector<ResponseParameter> parameters_of_recognition(const TabulatedQuestion& asked) {
  ParameterList list(asked);
  add_sensitivity(asked, {"right", "textures", "information"}, list);
  list.assumed({.name = "bias_sd",
                .range = ParameterRange::not_negative,
                .unit = "d′",
                .meaning = phrase("Responses",
                                  "SD over pictures of a participant's preference for a picture"),
                .value = 0.3});
  list.lapse();
  return list.take();
}

std::vector<ResponseParameter> parameters_of_matching(const TabulatedQuestion& asked) {
  ParameterList list(asked);
  add_sensitivity(asked, {"items", "whole", "textures"}, list);
  list.lapse();
  return list.take();
}

double sensitivity_to(const TabulatedTrial& trial, const std::string& texture) {
  const double of_participant = trial.values.at(std::string(kSensitivity) + "_sd") *
                                Random(trial.of_participant).split(kSensitivity).normal();
  const double of_texture =
      trial.values.at("texture_sd") * trial.of_study.split("texture").split(texture).normal();
  double of_group = 0.0;
  if (const auto* const groups = groups_in(trial.asked)) {
    of_group =
        std::log(trial.values.at(ratio_of_groups(groups->first))) * trial.place_of(groups->first);
  }
  return trial.values.at(kSensitivity) * std::exp(of_participant + of_texture + of_group);
}

/// How many of the options are pictures: all but "cannot tell", which is the last one.
std::size_t pictures_in(const Question& question) {
  return question.options.size() - (question.options.back().value == kCannotTellOption ? 1U : 0U);
}

Answer recognise_picture(const TabulatedTrial& trial) {
  Random noise = trial.of_response.split("impressions");
  const std::size_t pictures = pictures_in(trial.question);
  if (trial.lapses()) return ChosenOption{static_cast<std::size_t>(noise.below(pictures))};
  const std::string& correct = trial.question.correct.front();
  const double sensitivity = sensitivity_to(trial, trial.trial.presentations.front().item);
  std::size_t best = 0;
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pictures; ++i) {
    const std::string& picture = trial.question.options[i].value;
    const double impression = noise.normal() + (picture == correct ? sensitivity : 0.0) +
                              trial.own_of("bias", picture, trial.values.at("bias_sd"));
    if (impression <= greatest) continue;
    greatest = impression;
    best = i;
  }
  return ChosenOption{best};
}

/// The assignment of options to surfaces with the greatest sum of impressions, by surface; each option is used once. Dynamic
/// programming over sets of options: the best assignments of the first surfaces to every set of as many options.
std::vector<std::size_t> best_assignment(const std::vector<std::vector<double>>& impressions) {
  const std::size_t count = impressions.size();
  const std::size_t sets = std::size_t{1} << count;
  std::vector<double> best(sets, -std::numeric_limits<double>::infinity());
  std::vector<std::size_t> last(sets, 0);
  best[0] = 0.0;
  for (std::size_t set = 0; set + 1 < sets; ++set) {
    std::size_t surface = 0;
    for (std::size_t i = 0; i < count; ++i) surface += (set >> i) & 1U;
    for (std::size_t option = 0; option < count; ++option) {
      if (((set >> option) & 1U) != 0) continue;
      const std::size_t with = set | (std::size_t{1} << option);
      const double sum = best[set] + impressions[surface][option];
      if (sum <= best[with]) continue;
      best[with] = sum;
      last[with] = option;
    }
  }
  std::vector<std::size_t> options(count);
  for (std::size_t set = sets - 1, surface = count; surface-- > 0;) {
    options[surface] = last[set];
    set &= ~(std::size_t{1} << last[set]);
  }
  return options;
}

Answer match_pictures(const TabulatedTrial& trial) {
  Random noise = trial.of_response.split("impressions");
  const auto& surfaces = trial.trial.presentations;
  if (trial.lapses()) {
    std::vector<std::size_t> options(surfaces.size());
    std::iota(options.begin(), options.end(), std::size_t{0});
    noise.shuffle(std::span<std::size_t>(options));
    return AssignedOptions{std::move(options)};
  }
  std::vector<std::vector<double>> impressions{};
  for (const PlannedPresentation& surface : surfaces) {
    const double sensitivity = sensitivity_to(trial, surface.item);
    std::vector<double>& own = impressions.emplace_back();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      own.push_back(noise.normal() +
                    (trial.question.options[i].value == surface.item ? sensitivity : 0.0));
    }
  }
  return AssignedOptions{best_assignment(impressions)};
}

}  // namespace

const ResponseTable& recognition_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_recognition,
                                        .respond = recognise_picture};
  return kTable;
}

const ResponseTable& matching_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_matching,
                                        .respond = match_pictures};
  return kTable;
}

}  // namespace asperity
