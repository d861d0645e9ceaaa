// The tests, checks and judgement of a magnitude estimation.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <variant>

#include "protocols/design/wording.h"
#include "protocols/kinds/estimation.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/magnitude_responses.h"

namespace asperity {

namespace {

constexpr std::array kMagnitudeTests{
    KindTest{"spacing", "whether estimates depend on the spacing", false, kBySpacing, "stimuli"},
    KindTest{"interaction", "whether the effect of the spacing depends on the condition", false,
             kBySpacing, "stimuli_by_condition"},
    KindTest{"condition", "whether estimates depend on the condition"},
    KindTest{"peaks", "whether the peaks of two conditions differ, for every pair of conditions",
             false, kBySpacing},
    KindTest{"stimuli", "whether estimates depend on the stimulus", false, kByFactor},
    KindTest{"exponent",
             "with a predictor: whether the exponent of the power function differs from 0, for "
             "every condition",
             false, kByFactor},
    KindTest{"stimuli_by_condition",
             "whether the effect of the stimulus depends on "
             "the condition",
             false, kByFactor},
    KindTest{
        kGroupsTest,
        "with a predictor: whether the exponents of two groups differ, for every pair of groups"},
    KindTest{kGroupProfilesTest,
             "whether the effect of the stimulus differs between two groups, for every pair"}};

constexpr const char* kStandardRole = "standard";
constexpr std::array<std::string_view, 2> kMagnitudeRoles{"target", kStandardRole};

std::string item_factor_of_magnitude(const Protocol& protocol) {
  return protocol.estimation ? protocol.estimation->items : std::string();
}

/// A standard is not one of the items, and may have the texture of the estimated surface.
std::string item_of_magnitude(const PlannedPresentation& surface) {
  return surface.role == kStandardRole ? surface.role : surface.stimulus.texture;
}

/// One surface, which with a modulus the standard precedes.
void check_block_of_magnitude(const BlockOfKind& checked, ProblemSink& problems) {
  const std::vector<Protocol::Presented>& presented = checked.block.presented;
  const std::string place = checked.pointer + "/presented";
  const auto& estimation = checked.protocol.estimation;
  if (!estimation || !estimation->modulus) {
    if (presented.size() != 1) {
      problems.report(
          place, phrase("Protocols",
                        "a magnitude estimation presents exactly one surface per trial; list one "
                        "here, or state the number of a standard under %1")
                     .with(place_name("/estimation/modulus")));
    } else if (presented.front().role == kStandardRole) {
      problems.report(place + "/0/role",
                      phrase("Protocols",
                             "without a modulus the surface of a trial is the estimated one; write "
                             "%1, or state the number of a standard under %2")
                          .with(word_name("target"), place_name("/estimation/modulus")));
    }
    return;
  }
  if (presented.size() != 2 || presented[0].role != kStandardRole ||
      presented[1].role == kStandardRole) {
    problems.report(place,
                    phrase("Protocols",
                           "with a modulus each trial presents the standard and then the estimated "
                           "surface; list two surfaces, the first one with the role %1")
                        .with(in_quotes(kStandardRole)));
    return;
  }
  const auto level = presented[0].with.find(estimation->factor());
  if (level == presented[0].with.end() || text_of(level->second) != estimation->modulus->standard) {
    problems.report(
        place + "/0",
        phrase("Protocols",
               "the standard is the level %1 of the factor %2; state this level under %3")
            .with(in_quotes(estimation->modulus->standard), in_quotes(estimation->factor()),
                  key_name("with")));
  }
  if (checked.block.positions != Protocol::Block::Positions::as_listed) {
    problems.report(
        checked.pointer + "/positions",
        phrase("Protocols",
               "the standard precedes the estimated surface in every trial; set this to %1")
            .with(word_name("as_listed")));
  }
  if (checked.block.has_anchors() &&
      checked.block.anchor_places == std::vector{AnchorPlace::start}) {
    problems.report(checked.pointer + "/anchor",
                    phrase("Protocols",
                           "every trial begins with the standard, so that an anchor at the start "
                           "is not needed; remove this key, or name further places under %1")
                        .with(key_name("anchor_at")));
  }
  if (std::holds_alternative<LineForm>(checked.question.form)) {
    problems.report(checked.at_question + "/line",
                    phrase("Protocols",
                           "the standard has a number, to which a line without a number cannot be "
                           "compared; remove this key, or set %1 to %2")
                        .with(place_name("/estimation/modulus"), word_name("free")));
  }
}

void check_trial_of_magnitude(const BlockOfKind& checked, const Trial&, ProblemSink& problems) {
  if (checked.protocol.observer.expectation == ObserverDeclaration::Expectation::none) return;
  problems.report("/observer/expectation",
                  phrase("Protocols",
                         "an observer derives a magnitude estimate from the felt force and has no "
                         "expectation: set this to %1")
                      .with(word_name("none")));
}

VirtualResponse judge_magnitude(const Judgement& judgement) {
  if (std::holds_alternative<LineForm>(judgement.question.form)) {
    const LineHabit habit = line_habit_of(judgement.of_participant.split("lines"));
    return {
        DrawnLength{judgement.observer.draw_line(judgement.felt.back(), habit, LineForm::kSteps)},
        false};
  }
  NumberHabit habit = number_habit_of(judgement.of_participant.split("numbers"));
  const auto& estimation = judgement.protocol.estimation;
  if (!estimation || !estimation->modulus || judgement.felt.size() < 2) {
    return {GivenNumber{judgement.observer.estimate(judgement.felt.front(), habit)}, false};
  }
  habit.modulus = estimation->modulus->value;
  return {GivenNumber{judgement.observer.estimate(judgement.felt[1], judgement.felt[0], habit)},
          false};
}

}  // namespace

const ExperimentKind& magnitude_kind() {
  static const std::array kKeys{RequiredKey{
      "estimation",
      phrase("Protocols",
             "a magnitude estimation must state the factor by which estimates are analysed: add "
             "the key %1 with this factor as %2, or as %3 for other stimuli")
          .with(key_name("estimation"), key_name("spacing"), key_name("factor"))}};
  static const ExperimentKind kKind{.id = "magnitude",
                                    .name = phrase("Protocols", "magnitude estimation"),
                                    .roles = kMagnitudeRoles,
                                    .form = NumberForm{.is_estimate = true},
                                    .other_form = LineForm{},
                                    .anchor_role = "anchor",
                                    .tests = kMagnitudeTests,
                                    .required = kKeys,
                                    .item_factor = item_factor_of_magnitude,
                                    .item_of = item_of_magnitude,
                                    .check = check_estimation,
                                    .check_block = check_block_of_magnitude,
                                    .check_trial = check_trial_of_magnitude,
                                    .judge = judge_magnitude,
                                    .responses = &magnitude_responses()};
  return kKind;
}

}  // namespace asperity
