// Calls the figures of each family by its name. Families do not declare them: figures are values of outcomes, and outcomes are
// made with families.

#include "app/findings/study/family_figures.h"

#include "app/findings/methods/discrimination/sensitivity/roc_figures.h"
#include "app/findings/methods/discrimination/thresholds/psychometric_figures.h"
#include "app/findings/methods/discrimination/thresholds/track_figure.h"
#include "app/findings/methods/magnitude/roughness_figure.h"
#include "app/findings/methods/rating/biplot_figure.h"
#include "app/findings/methods/similarity/perceptual_map_figures.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/group_figures.h"
#include "app/findings/shared/figures/confusion_figure.h"
#include "app/findings/shared/figures/forest_figures.h"
#include "app/findings/shared/figures/mean_figures.h"
#include "app/findings/shared/figures/power_figure.h"
#include "app/findings/shared/figures/response_time_figures.h"
#include "app/findings/shared/figures/scale_figure.h"
#include "app/findings/shared/figures/similarity_figures.h"

namespace asperity {

std::vector<Figure> figures_of(const std::string& family, const TidyInput& input,
                               std::span<const Finding> findings, const std::string& level_unit) {
  const FoundNumbers found(findings);
  if (family == "components") return {biplot_figure(found)};
  if (family == "group") return group_figures(shares_of_groups(), found);
  if (family == "learning") {
    return {input.table().has("time_s") ? times_over_trials_figure(found)
                                        : correct_over_trials_figure(found)};
  }
  if (family == "magnitude") return {roughness_figure(found, level_unit, CurveNames::of_probes)};
  if (family == "matching") return {matching_forest(found), confusion_figure(found)};
  if (family == "paired") return {scale_figure("preference", bradley_terry(), found)};
  if (family == "power") return {power_figure(input, found)};
  if (family == "proportion") return {proportion_forest(input, found)};
  if (family == "psyfit") return {psychometric_figure(input, found, level_unit)};
  if (family == "ranking") return {scale_figure("preference", plackett_luce(), found)};
  if (family == "rating") return {rating_figure(found)};
  if (family == "recognition") {
    return {recognition_forest(found), confusion_figure(found), dendrogram(found),
            similarity_map(found)};
  }
  if (family == "response_times") return {response_times_figure(found)};
  if (family == "rmanova") return {interaction_figure(input, found, level_unit)};
  if (family == "roc") {
    std::vector<RocCurve> curves{};
    for (const std::string& name : input.table().all_labels("condition").names) {
      curves.push_back({.key = name, .name = words_of_condition(name)});
    }
    return {roc_figure(found, curves)};
  }
  if (family == "seedpaper") return seedpaper_forests(found);
  if (family == "selection") return {selection_forest(found)};
  if (family == "similarity") {
    return {configuration_figure(found), shepard_figure(found), stress_figure(found),
            dendrogram(found, rated_tree()), weights_figure(found)};
  }
  if (family == "staircase") return {tracks_figure(track_trials(input, found), level_unit)};
  return {};
}

}  // namespace asperity
