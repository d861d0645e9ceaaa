// Declares the claims of the tests, the task by its scales, and the parameters that the ratings show.

#include "app/findings/methods/rating/rating_analysis.h"

#include <array>
#include <numbers>
#include <optional>
#include <string>

#include "app/findings/methods/rating/rating_sentences.h"
#include "app/findings/outcome/analysis_list.h"
#include "app/findings/outcome/task_words.h"

namespace asperity {

namespace {

constexpr std::array kRatingClaims{
    TestClaim{"ratings", "",
              "The ratings on the scale “%1” differed significantly between the items", "",
              "The ratings on the scale “%1” did not differ significantly between the items"},
    TestClaim{"rated_pairs", "", "The item %1 was rated significantly higher than %2%4",
              "The item %1 was rated significantly lower than %2%4",
              "The ratings of %1 and %2%4 were not significantly different"},
    TestClaim{
        "rating_model", "",
        "The mean ratings on the scale “%1” differed significantly between the items in the "
        "analysis of variance",
        "",
        "The mean ratings on the scale “%1” did not differ significantly between the items in "
        "the analysis of variance"},
    TestClaim{"accompanying_scales", "",
              "The ratings on the scale “%1” were significantly higher with correct than with "
              "incorrect responses to the question “%2”",
              "The ratings on the scale “%1” were significantly lower with correct than with "
              "incorrect responses to the question “%2”",
              "The ratings on the scale “%1” did not differ significantly between correct and "
              "incorrect responses to the question “%2”"},
    TestClaim{kGroupsTest, "",
              "The mean ratings%4 were significantly higher in the group %1 than in the group %2",
              "The mean ratings%4 were significantly lower in the group %1 than in the group %2",
              "The mean ratings%4 of the groups %1 and %2 were not significantly different"},
    TestClaim{kGroupProfilesTest, "",
              "The differences between the items in the ratings%4 were significantly different in "
              "the groups %1 and %2",
              "",
              "The differences between the items in the ratings%4 were not significantly different "
              "in the groups %1 and %2"}};

std::string task_of_rating(const Protocol& protocol) {
  return "Task: in each trial, ratings are given on " + scales_of_blocks(protocol, "rating") + '.';
}

std::string paper_task_of_rating(const Protocol& protocol) {
  return ", and ratings were given on " + scales_of_blocks(protocol, "rating") + '.';
}

std::string fit_of_rating(const Protocol&, const AnalysisOutcome& outcome) {
  return rating_methods_text(outcome);
}

/// The cell of a response: the item of its surface where the block has several, and the levels of the factors.
FindingKey cell_of_response(const GatheredAnswers& gathered, const GatheredAnswer& answer,
                            const TabulatedQuestion& asked) {
  if (asked.items.size() > 1) {
    return gathered.word(gathered.surfaces_of(answer).front().item);
  }
  FindingKey cell{};
  for (const auto& [factor, levels] : asked.factors) {
    cell = {cell, gathered.word(gathered.level(answer, factor))};
  }
  if (asked.block.vary)
    cell = {cell, gathered.word(gathered.level(answer, asked.block.vary->factor))};
  return cell;
}

/// Of a rating: level, level_sd and noise_sd, and with several items difference_sd (√2·VarianceComponents::interaction_sd). The
/// limits of the scale are ignored.
ShownParameters shown_rating_parameters(const GatheredAnswers& gathered,
                                        const TabulatedQuestion& asked) {
  ShownParameters shown{};
  const auto components = add_shown_components(
      gathered, asked,
      [&](const GatheredAnswer& answer) { return cell_of_response(gathered, answer, asked); },
      [](double number) { return std::optional(number); }, shown);
  if (!components) return shown;
  shown["difference_sd"] = std::numbers::sqrt2 * components->interaction_sd;
  return shown;
}

}  // namespace

const StudyAnalysis& rating_analysis() {
  static const StudyAnalysis kAnalysis{
      .kind = "rating",
      .name = phrase("Analysis", "rating"),
      .claims = kRatingClaims,
      .task = task_of_rating,
      .task_for_paper = paper_task_of_rating,
      .fit_for_paper = fit_of_rating,
      .transformation =
          "Each participant's ratings of an item were averaged before they were analysed.",
      .analyze = analyze_rating,
      .test_family = test_ratings,
      .shown_parameters = shown_rating_parameters,
      .estimates = rating_estimates_sentence};
  return kAnalysis;
}

}  // namespace asperity
