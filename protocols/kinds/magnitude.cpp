// The tests, checks and judgement of a magnitude estimation.

#include "protocols/kinds/magnitude.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <variant>

#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"

namespace asperity {

namespace {

constexpr std::array kMagnitudeTests{
    KindTest{"spacing", "do estimates depend on the spacing"},
    KindTest{"interaction", "does the curve over spacings depend on the condition"},
    KindTest{"condition", "do estimates depend on the condition"},
    KindTest{"peaks", "for every pair of conditions: do their peaks differ"}};

constexpr std::array kMagnitudeKeys{KindKey{
    "estimation",
    "a magnitude estimation must state the factor by which estimates are analysed: add the key "
    "\"estimation\" with this factor as \"spacing\"",
    "only a magnitude estimation has estimates to be analysed; remove this key"}};

std::string item_of_magnitude(const PlannedPresentation& surface) {
  return surface.stimulus.texture;
}

void check_block_of_magnitude(const BlockOfKind& checked, ProblemSink& problems) {
  const Protocol::TrialQuestionTemplate& question = checked.question;
  const std::string& place = checked.at_question;
  if (checked.block.presented.size() != 1) {
    problems.report(checked.pointer + "/presented",
                    "a magnitude estimation presents exactly one surface per trial; list one here");
  }
  if (!question.pictures.empty()) {
    problems.report(
        place + "/pictures",
        "a magnitude estimation is answered by a number, not by a picture; remove this key");
  }
  if (question.allow_cannot_tell) {
    problems.report(place + "/allow_cannot_tell",
                    "in a magnitude estimation every surface is given a number, and \"cannot "
                    "tell\" is not available; set this to false");
  }
  if (!question.correct_factor.empty()) {
    problems.report(place + "/correct_factor",
                    "a magnitude estimate is neither correct nor incorrect; remove this key");
  }
}

void check_spacings(const Protocol& protocol, const std::string& factor, ProblemSink& problems) {
  const std::string at_levels = pointer_to("/factors", factor) + "/levels";
  const std::vector<Level>& levels = protocol.factors.at(factor).levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string place = pointer_to(at_levels, i);
    if (const double* const spacing_m = std::get_if<double>(&levels[i])) {
      if (*spacing_m <= 0.0)
        problems.report(place, "a spacing must be above 0; write a length in metres");
      continue;
    }
    const auto texture = protocol.textures.find(text_of(levels[i]));
    if (texture == protocol.textures.end()) {
      problems.report(place,
                      in_quotes(text_of(levels[i])) +
                          " is used as a spacing but is neither a number nor a texture; write "
                          "a length in metres, or the name of a texture");
    } else if (!texture->second.spacing_m) {
      problems.report(
          pointer_to("/textures", texture->first),
          "estimates are analysed by the spacing of this texture: give it a \"spacing_m\"");
    }
  }
  std::set<double> spacings{};
  for (const auto& [level, spacing_m] : protocol.estimation->spacing_m) spacings.insert(spacing_m);
  constexpr std::size_t kCoefficients = 3;  // of a parabola
  if (spacings.size() < kCoefficients) {
    problems.report(at_levels, "a curve needs at least three different spacings; number given: " +
                                   std::to_string(spacings.size()) + "; add spacings");
  }
}

/// A main block varies the spacing and keeps the condition constant.
void check_design_of(const Protocol& protocol, const Protocol::Block& block, bool has_spacing,
                     bool has_condition, ProblemSink& problems) {
  const EstimationDeclaration& estimation = *protocol.estimation;
  const std::string pointer = pointer_to("/blocks", block.name);
  const auto crosses = [&block](const std::string& factor) {
    return std::find(block.crossed.begin(), block.crossed.end(), factor) != block.crossed.end();
  };
  const bool lists_spacing =
      std::any_of(block.listed.begin(), block.listed.end(),
                  [&](const auto& row) { return row.contains(estimation.spacing); });
  if (has_spacing && !crosses(estimation.spacing) && !lists_spacing) {
    problems.report(pointer, "a main block must cross or list the spacings, the factor " +
                                 in_quotes(estimation.spacing));
  }
  if (!has_condition) return;
  std::set<Level> held{};
  for (const auto& row : block.listed) {
    const auto level = row.find(estimation.condition);
    if (level != row.end()) held.insert(level->second);
  }
  const bool draws =
      std::find(block.drawn.begin(), block.drawn.end(), estimation.condition) != block.drawn.end();
  if (held.size() > 1 || crosses(estimation.condition) || draws) {
    problems.report(pointer,
                    "the condition must be constant within a block: run this block for_each level "
                    "of " +
                        in_quotes(estimation.condition) + " instead of mixing the levels");
    return;
  }
  for (const Protocol::Run* const run : runs_of(protocol, block)) {
    if (factors_set_by(block, run).contains(estimation.condition)) continue;
    problems.report(pointer, "this main block does not set the condition " +
                                 in_quotes(estimation.condition) +
                                 ": run the block for_each level of the condition");
  }
}

void check_magnitude(const Protocol& protocol, ProblemSink& problems) {
  if (!protocol.estimation) return;
  const EstimationDeclaration& estimation = *protocol.estimation;
  const auto is_known = [&](const std::string& factor, const char* key) {
    if (factor.empty() || protocol.factors.contains(factor)) return !factor.empty();
    problems.report(std::string("/estimation/") + key,
                    unknown_name("factor", factor, protocol.factors));
    return false;
  };
  const bool has_spacing = is_known(estimation.spacing, "spacing");
  const bool has_condition = is_known(estimation.condition, "condition");
  if (has_spacing) check_spacings(protocol, estimation.spacing, problems);
  if (estimation.condition == estimation.spacing) {
    problems.report("/estimation/condition",
                    "spacing and condition are the same factor; name another one");
    return;
  }
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != "magnitude") continue;
    check_design_of(protocol, block, has_spacing, has_condition, problems);
  }
}

void check_trial_of_magnitude(const BlockOfKind& checked, const Trial&, ProblemSink& problems) {
  if (checked.protocol.observer.expectation == ObserverDeclaration::Expectation::none) return;
  problems.report(
      "/observer/expectation",
      "an observer derives a magnitude estimate from the felt force and has no expectation: set "
      "this to \"none\"");
}

VirtualResponse judge_magnitude(const Judgement& judgement) {
  const NumberHabit habit = number_habit_of(judgement.of_participant.split("numbers"));
  return {GivenNumber{judgement.observer.estimate(judgement.felt.front(), habit)}, false};
}

}  // namespace

const ExperimentKind& magnitude_kind() {
  static const ExperimentKind kKind{.id = "magnitude",
                                    .name = "magnitude estimation",
                                    .roles = kTargetRole,
                                    .form = NumberForm{},
                                    .has_anchors = true,
                                    .tests = kMagnitudeTests,
                                    .keys = kMagnitudeKeys,
                                    .item_of = item_of_magnitude,
                                    .check = check_magnitude,
                                    .check_block = check_block_of_magnitude,
                                    .check_trial = check_trial_of_magnitude,
                                    .judge = judge_magnitude};
  return kKind;
}

}  // namespace asperity
