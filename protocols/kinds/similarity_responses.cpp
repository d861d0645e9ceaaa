// Draws dissimilarities that grow with the distance of the items in their order.

#include "protocols/kinds/similarity_responses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "protocols/kinds/similarity.h"

namespace asperity {

namespace {

constexpr const char* kStructure = "structure";
constexpr const char* kIdentical = "identical";

std::vector<ResponseParameter> parameters_of_similarity(const TabulatedQuestion& asked) {
  const auto& form = std::get<ScaleForm>(asked.question.form);
  const double range = form.maximum - form.minimum;
  const Phrase on_scale = scale_text(form);
  ParameterList list(asked);
  list.effect(
      {.effect = {.name = kStructure,
                  .unit = kScaleUnits,
                  .meaning = phrase("Responses",
                                    "mean dissimilarity of the most distant pair minus that of "
                                    "neighbours, %1; the items are equally spaced on one dimension")
                                 .with(on_scale)},
       .tests = {"configuration", "properties"},
       .sd_unit = kScaleUnits,
       .sd_meaning =
           phrase("Responses", "SD over participants of the difference between any two pairs"),
       .usual_sd = 0.15 * range});
  if (asked.block.all_pairs && asked.block.all_pairs->with_identical) {
    list.effect(
        {.effect = {.name = kIdentical,
                    .unit = kScaleUnits,
                    .meaning =
                        phrase("Responses",
                               "mean dissimilarity of different minus that of identical pairs, %1")
                            .with(on_scale)},
         .tests = {"identical"},
         .sd_unit = kScaleUnits,
         .sd_meaning = phrase("Responses", "SD over participants of this difference"),
         .usual_sd = 0.1 * range});
  }
  list.scale(
      range,
      {.meaning = phrase("Responses",
                         "mean dissimilarity of the pairs of different items, from 0 at the end of "
                         "the scale for identical surfaces"),
       .value = 0.5 * range},
      phrase("Responses", "SD over participants of this mean"),
      phrase("Responses", "SD of the ratings of one participant for one pair"));
  return list.take();
}

/// g: −½ for neighbours, ½ for the extremes; 0 with two items.
double distance_of(const TabulatedQuestion& asked, const std::string& one,
                   const std::string& other) {
  if (asked.items.size() < 3) return 0.0;
  const double neighbours = 1.0 / static_cast<double>(asked.items.size() - 1);
  const double distance = std::abs(place_among(asked.items, one) - place_among(asked.items, other));
  return (distance - neighbours) / (1.0 - neighbours) - 0.5;
}

/// The part of y without level and noise.
double pair_deviation(const TabulatedTrial& trial) {
  const std::string& one = trial.trial.presentations[0].item;
  const std::string& other = trial.trial.presentations[1].item;
  if (one == other) {
    const auto& pairs = trial.asked.block.all_pairs;
    return pairs && pairs->with_identical ? -trial.own(kIdentical) : 0.0;
  }
  const double sd = trial.values.at(std::string(kStructure) + "_sd");
  return trial.values.at(kStructure) * distance_of(trial.asked, one, other) +
         trial.own_of(kStructure, std::min(one, other) + '|' + std::max(one, other),
                      sd / std::numbers::sqrt2);
}

Answer rate_dissimilarity(const TabulatedTrial& trial) {
  const auto& form = std::get<ScaleForm>(trial.question.form);
  Random noise = trial.of_response.split("rating");
  if (trial.lapses()) {
    const auto points = static_cast<std::uint64_t>(form.steps()) + 1;
    return ScalePoint{static_cast<int>(noise.below(points))};
  }
  const double dissimilarity =
      trial.own("level") + pair_deviation(trial) + trial.values.at("noise_sd") * noise.normal();
  const double share = std::clamp(dissimilarity / (form.maximum - form.minimum), 0.0, 1.0);
  const bool is_reversed = rated_quantity(trial.asked.question) == RatedQuantity::similarity;
  return ScalePoint{
      static_cast<int>(std::lround((is_reversed ? 1.0 - share : share) * form.steps()))};
}

}  // namespace

const ResponseTable& similarity_responses() {
  static constexpr ResponseTable kTable{.parameters = parameters_of_similarity,
                                        .respond = rate_dissimilarity};
  return kTable;
}

}  // namespace asperity
