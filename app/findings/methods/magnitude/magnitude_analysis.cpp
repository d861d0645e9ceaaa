// Declares the claims of the tests, and describes the task by its modulus, its lines and its normalisation.

#include "app/findings/methods/magnitude/magnitude_analysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/magnitude/magnitude_sentences.h"
#include "app/findings/outcome/analysis_list.h"
#include "app/findings/outcome/display_number.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr std::array kMagnitudeClaims{
    TestClaim{"spacing", "", "The roughness estimates differed significantly between the spacings",
              "", "The roughness estimates did not differ significantly between the spacings"},
    TestClaim{
        "interaction", "",
        "The effect of spacing on the roughness estimates differed significantly between the "
        "conditions",
        "",
        "The effect of spacing on the roughness estimates did not differ significantly between "
        "the conditions"},
    TestClaim{"condition", "",
              "The roughness estimates differed significantly between the conditions", "",
              "The roughness estimates did not differ significantly between the conditions"},
    TestClaim{"peaks", "", "The peak of %1 was at a significantly larger spacing than that of %2",
              "The peak of %1 was at a significantly smaller spacing than that of %2",
              "The spacings of the peaks of %1 and %2 were not significantly different"},
    TestClaim{"stimuli", "", "The estimates differed significantly between the stimuli", "",
              "The estimates did not differ significantly between the stimuli"},
    TestClaim{"exponent", "", "The exponent for %1 was significantly above 0",
              "The exponent for %1 was significantly below 0",
              "The exponent for %1 was not significantly different from 0"},
    TestClaim{"stimuli_by_condition", "",
              "The effect of the stimulus on the estimates differed significantly between the "
              "conditions",
              "",
              "The effect of the stimulus on the estimates did not differ significantly between "
              "the conditions"},
    TestClaim{kGroupsTest, "",
              "The exponents%5 were significantly larger in the group %1 than in the group %2",
              "The exponents%5 were significantly smaller in the group %1 than in the group %2",
              "The exponents%5 of the groups %1 and %2 were not significantly different"},
    TestClaim{kGroupProfilesTest, "",
              "The effect of the stimulus on the estimates was significantly different in the "
              "groups %1 and %2",
              "",
              "The effect of the stimulus on the estimates was not significantly different in the "
              "groups %1 and %2"}};

/// The lines by which a main block of magnitude estimation is answered; null where numbers answer it.
const LineForm* lines_of(const Protocol& protocol) {
  for (const auto& [name, block] : protocol.blocks) {
    if (block.kind != "magnitude" || block.phase != Phase::main) continue;
    for (const auto& question : block.questions) {
      const auto* const lines = std::get_if<LineForm>(&question.form);
      if (lines != nullptr && kind_of_question(kind_of(block), question) != nullptr) return lines;
    }
  }
  return nullptr;
}

bool is_answered_by_lines(const Protocol& protocol) { return lines_of(protocol) != nullptr; }

const EstimationModulus* modulus_of(const Protocol& protocol) {
  return protocol.estimation && protocol.estimation->modulus ? &*protocol.estimation->modulus
                                                             : nullptr;
}

bool has_spacings(const Protocol& protocol) {
  return !protocol.estimation || protocol.estimation->items.empty();
}

std::string task_of_magnitude(const Protocol& protocol) {
  const std::string to_what = has_spacings(protocol) ? "its roughness" : "it";
  if (const EstimationModulus* const modulus = modulus_of(protocol)) {
    return "Task: in each trial, a standard with the number " + number_text(modulus->value) +
           " is presented and then another surface, and a number is to be assigned to " +
           (has_spacings(protocol) ? "the roughness of the latter" : "the latter") +
           " (magnitude estimation, standard with modulus " + number_text(modulus->value) + ").";
  }
  if (is_answered_by_lines(protocol)) {
    return "Task: in each trial, one surface is presented, and a line is to be drawn whose length "
           "matches " +
           to_what + " (cross-modality matching to line length).";
  }
  return "Task: in each trial, one surface is presented, and a number is to be assigned to " +
         to_what + " (absolute magnitude estimation with free modulus).";
}

std::string paper_task_of_magnitude(const Protocol& protocol) {
  const std::string to_what = has_spacings(protocol) ? "its roughness" : "it";
  if (const EstimationModulus* const modulus = modulus_of(protocol)) {
    return ", the first of which was a standard with the number " + number_text(modulus->value) +
           ", and a number above 0 was to be assigned to " +
           (has_spacings(protocol) ? "the roughness of the second" : "the second") +
           " (magnitude estimation, standard with modulus " + number_text(modulus->value) + ").";
  }
  if (const LineForm* const lines = lines_of(protocol)) {
    return ", and a line was to be drawn whose length matched " + to_what +
           " (cross-modality matching to line length; the longest line had " +
           display_percent(lines->longest) + " of the width of the screen).";
  }
  return ", and a number above 0 was to be assigned to " + to_what +
         " (absolute magnitude estimation with free modulus).";
}

std::string transformation_of_magnitude(const Protocol& protocol) {
  const EstimateNormalisation normalisation = protocol.estimation
                                                  ? protocol.estimation->normalisation()
                                                  : EstimateNormalisation::geometric_mean;
  const std::string logarithms = is_answered_by_lines(protocol)
                                     ? "Lengths of lines were analysed as logarithms"
                                     : "Estimates were analysed as logarithms";
  const std::string number =
      modulus_of(protocol) == nullptr ? std::string() : number_text(modulus_of(protocol)->value);
  switch (normalisation) {
    case EstimateNormalisation::geometric_mean:
      return logarithms +
             ". For means, curves and exponents each participant's estimates were normalised by "
             "the geometric mean of that participant's cells.";
    case EstimateNormalisation::standard:
      return logarithms +
             ". For means, curves and exponents each participant's estimates were divided by the "
             "geometric mean of that participant's estimates of the standard and multiplied by its "
             "modulus, " +
             number + ".";
    case EstimateNormalisation::none:
      break;
  }
  return logarithms + ". They were not normalised, because the standard determined the modulus, " +
         number + ", for all participants.";
}

/// Of a magnitude estimation, from logarithms (base 10) in the cells of stimuli and conditions: level and level_sd (without a
/// standard), and noise_sd.
ShownParameters shown_magnitude_parameters(const GatheredAnswers& gathered,
                                           const TabulatedQuestion& asked) {
  const auto* const line = std::get_if<LineForm>(&asked.question.form);
  const double longest = line == nullptr ? 1.0 : line->longest;
  ShownParameters shown{};
  add_shown_components(
      gathered, asked,
      [&](const GatheredAnswer& answer) {
        return FindingKey{gathered.word(gathered.level(answer, gathered.estimation.factor())),
                          gathered.word(gathered.level(answer, gathered.estimation.condition))};
      },
      [longest](double number) {
        return number > 0.0 ? std::optional(std::log10(number / longest)) : std::nullopt;
      },
      shown);
  return shown;
}

}  // namespace

const StudyAnalysis& magnitude_analysis() {
  static const StudyAnalysis kAnalysis{
      .kind = "magnitude",
      .name = phrase("Analysis", "magnitude estimation"),
      .claims = kMagnitudeClaims,
      .task = task_of_magnitude,
      .task_for_paper = paper_task_of_magnitude,
      .transformation =
          "Estimates were analysed as logarithms. For means, curves and exponents each "
          "participant's estimates were normalised by the geometric mean of that participant's "
          "cells.",
      .transformation_of = transformation_of_magnitude,
      .analyze = analyze_magnitude,
      .test_family = test_magnitude,
      .shown_parameters = shown_magnitude_parameters,
      .estimates = exponents_sentence};
  return kAnalysis;
}

}  // namespace asperity
