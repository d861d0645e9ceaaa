// The tests, checks and judgement of a discrimination.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/design/block_factors.h"
#include "protocols/design/wording.h"
#include "protocols/kinds/discrimination_responses.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/positions.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

constexpr std::array kDiscriminationTests{
    KindTest{"order", "whether the comparison is chosen equally often in both positions"},
    KindTest{"conditions", "whether the thresholds differ between the conditions"},
    KindTest{"point_of_subjective_equality",
             "whether the point of subjective equality differs from the standard; only with the "
             "judgement `comparison`"},
    KindTest{kGroupsTest,
             "whether the thresholds of two groups differ, or with a single level d′, for every "
             "pair of groups"}};

constexpr std::array<std::string_view, 2> kDiscriminationRoles{"standard", "comparison"};

std::string item_of_discrimination(const PlannedPresentation& surface) { return surface.role; }

/// The design whose options the question has; null where a surface is chosen.
const DiscriminationDesign* design_answered_by(const Protocol::TrialQuestionTemplate& question) {
  return question.options.empty() ? nullptr : design_with_option(question.options.front().value);
}

std::vector<std::string> correct_of_discrimination(const Protocol::TrialQuestionTemplate& question,
                                                   const Trial& trial) {
  const auto comparisons = static_cast<std::size_t>(std::count_if(
      trial.presentations.begin(), trial.presentations.end(),
      [](const PlannedPresentation& planned) { return planned.role == "comparison"; }));
  if (const DiscriminationDesign* const design = design_answered_by(question)) {
    return {std::string(design->correct_response(comparisons))};
  }
  if (trial.catch_trial && trial.catch_trial->type != CatchType::easy) return {kCannotTellOption};
  if (question.judgement() == DiscriminationJudgement::performance) {
    return {comparisons > 1 ? "standard" : "comparison"};  // the standard is odd among comparisons
  }
  // The level of a catch trial is so far from the standard that the response is known.
  if (!trial.catch_trial) return {};
  return {trial.catch_trial->is_above_standard != question.asks_for_less() ? "comparison"
                                                                           : "standard"};
}

/// Where every level is above the standard, or every level below it.
bool is_one_sided(const Dimension& dimension) {
  const std::vector<double> values = dimension.values();
  const double standard = *dimension.standard;
  return values.front() > standard || values.back() < standard;
}

bool is_two_sided(const Dimension& dimension) {
  const std::vector<double> values = dimension.values();
  return values.front() < *dimension.standard && values.back() > *dimension.standard;
}

/// Whether the block varies the comparison relative to a standard of a known value.
bool check_varied(const BlockOfKind& checked, ProblemSink& problems) {
  const std::optional<Dimension>& vary = checked.block.vary;
  if (!vary) {
    problems.report(checked.pointer, phrase("Protocols",
                                            "a discrimination needs the parameter in which the "
                                            "comparison differs from the standard; add %1")
                                         .with(key_name("vary")));
    return false;
  }
  if (vary->role != "comparison") {
    problems.report(checked.pointer + "/vary/of",
                    phrase("Protocols", "a discrimination varies the comparison; write %1")
                        .with(word_name("comparison")));
    return false;
  }
  if (vary->standard_role != "standard") {
    problems.report(
        checked.pointer + "/vary",
        phrase("Protocols",
               "the levels of a discrimination are compared with the standard; set %1 to %2")
            .with(key_name("relative_to"), word_name("standard")));
    return false;
  }
  if (!vary->standard && is_relative(vary->measure)) return false;  // reported with the levels
  if (!vary->standard) {
    problems.report(
        checked.pointer + "/vary/relative_to",
        phrase("Protocols",
               "the stimulus of the standard does not state a number for %1; state it there")
            .with(in_quotes(vary->parameter)));
    return false;
  }
  return has_levels(*vary);  // otherwise reported at the levels
}

/// The options of the question, and what only one of the designs can have.
void check_design(const BlockOfKind& checked, ProblemSink& problems) {
  const DiscriminationDesign& design = *checked.block.design();
  const Protocol::TrialQuestionTemplate& question = checked.question;
  const Phrase a_design = design.with_article;
  if (!design.has_noise() && !question.options.empty()) {
    problems.report_key(checked.at_question + "/options",
                        phrase("Protocols",
                               "in %1 the options are the surfaces felt; remove this key, or state "
                               "another %2 of the block")
                            .with(a_design, key_name("design")));
  }
  if (&design != &two_alternatives() &&
      question.judgement() == DiscriminationJudgement::comparison) {
    problems.report(checked.at_question + "/judgement",
                    phrase("Protocols", "in %1 one response is correct; set it to %2")
                        .with(a_design, word_name("performance")));
  }
  if (!design.has_noise()) return;
  std::set<std::string_view> options{};
  for (const Option& word : question.options) {
    options.insert(word.value);
  }
  if (question.options.size() != 2 || options != std::set{design.yes, design.no}) {
    problems.report(
        checked.at_question,
        phrase("Protocols", "%1 has the %2 %3 and %4; list these two values")
            .with(a_design, key_name("options"), in_quotes(design.yes), in_quotes(design.no)));
  }
  if (checked.block.procedure) {
    problems.report_key(
        checked.pointer + "/procedure",
        phrase(
            "Protocols",
            "%1 presents every level equally often, because a proportion correct depends on the "
            "criterion of the participant as well as on the level; remove this key, and state %2")
            .with(a_design, key_name("repetitions")));
  }
  if (design.surfaces() == 1) {
    if (checked.block.positions != Block::Positions::as_listed) {
      problems.report_key(
          checked.pointer + "/positions",
          phrase("Protocols", "%1 presents one surface in each trial; remove this key")
              .with(a_design));
    }
    if (checked.block.arrangement.surfaces != Arrangement::Surfaces::sequential) {
      problems.report(checked.pointer + "/arrangement/surfaces",
                      phrase("Protocols", "%1 presents one surface in each trial; set it to %2")
                          .with(a_design, word_name("sequential")));
    }
  }
  const ObserverDeclaration& observer = checked.protocol.observer;
  const bool has_criterion = design.surfaces() == 1
                                 ? observer.discrimination.yes_above.has_value()
                                 : observer.discrimination.different_above.has_value();
  if (!has_criterion && !observer.deaf) {
    problems.report(
        checked.pointer + "/design",
        phrase("Protocols",
               "the virtual observer of %1 needs a criterion; state %2 under %3, or %4: true")
            .with(a_design, key_name(design.surfaces() == 1 ? "yes_above" : "different_above"),
                  key_name("observer"), key_name("deaf")));
  }
}

void check_judgement(const BlockOfKind& checked, ProblemSink& problems) {
  if (!checked.question.judgement()) {
    problems.report(
        checked.at_question,
        phrase("Protocols",
               "a discrimination needs %1: %2 where the comparison is the correct response, or %3 "
               "where no response is correct")
            .with(key_name("judgement"), word_name("performance"), word_name("comparison")));
    return;
  }
  if (!check_varied(checked, problems)) return;
  if (checked.block.design()->has_noise() &&
      *checked.question.judgement() == DiscriminationJudgement::comparison) {
    return;  // reported with the design
  }
  const Dimension& dimension = *checked.block.vary;
  if (dimension.levels().empty()) return;  // reported with the parameter
  const std::string at_levels = checked.pointer + "/vary/" + std::string(key_of(dimension.measure));
  if (*checked.question.judgement() == DiscriminationJudgement::performance) {
    if (!is_one_sided(dimension)) {
      problems.report(at_levels,
                      phrase("Protocols",
                             "with the judgement %1 the comparison is the correct response, so "
                             "that every level must be above the standard, or every level below "
                             "it; remove the others, or use the judgement %2")
                          .with(word_name("performance"), word_name("comparison")));
    }
    return;
  }
  if (!is_two_sided(dimension)) {
    problems.report(
        at_levels,
        phrase("Protocols",
               "the judgement %1 estimates the point of subjective equality, which needs levels "
               "below and above the standard; add some, or use the judgement %2")
            .with(word_name("comparison"), word_name("performance")));
  }
  if (checked.block.feedback != Block::Feedback::none) {
    problems.report(
        checked.pointer + "/feedback",
        phrase("Protocols",
               "with the judgement %1 no response is correct or incorrect; set it to %2")
            .with(word_name("comparison"), word_name("none")));
  }
  if (checked.block.until) {
    problems.report(
        checked.pointer + "/until",
        phrase("Protocols",
               "with the judgement %1 no response is correct or incorrect; remove this key")
            .with(word_name("comparison")));
  }
}

void check_block_of_discrimination(const BlockOfKind& checked, ProblemSink& problems) {
  const Protocol::TrialQuestionTemplate& question = checked.question;
  const std::vector<Protocol::Presented>& presented = checked.block.presented;
  const auto has_role = [&presented](std::string_view role) {
    return std::count_if(presented.begin(), presented.end(),
                         [role](const auto& each) { return each.role == role; }) == 1;
  };
  if (presented.size() != 2 || !has_role("standard") || !has_role("comparison")) {
    problems.report(checked.pointer + "/presented",
                    phrase("Protocols",
                           "a discrimination presents one surface with the role %1 and one with "
                           "the role %2; list these two")
                        .with(word_name("standard"), word_name("comparison")));
    return;
  }
  for (std::size_t i = 0; i < presented.size(); ++i) {
    if (presented[i].item.empty()) continue;
    problems.report_key(
        checked.pointer + "/presented/" + std::to_string(i) + "/item",
        phrase("Protocols", "in a discrimination the role names each surface; remove this key"));
  }
  if (checked.block.design()->surfaces() > 1) check_positions(checked, problems);
  if (question.allow_cannot_tell && checked.block.design()->has_noise()) {
    problems.report(
        checked.at_question + "/allow_cannot_tell",
        phrase("Protocols", "%1 has the %2 %3 and %4; remove this key")
            .with(checked.block.design()->with_article, key_name("options"),
                  in_quotes(checked.block.design()->yes), in_quotes(checked.block.design()->no)));
  }
  if (question.allow_cannot_tell && checked.block.design()->is_choice_of_three()) {
    problems.report(
        checked.at_question + "/allow_cannot_tell",
        phrase("Protocols", "the analysis of %1 needs a choice in every trial; remove this key")
            .with(checked.block.design()->with_article));
  }
  check_design(checked, problems);
  check_judgement(checked, problems);
}

/// Whether all levels of the block are below the standard.
bool is_below_standard(const Dimension& dimension) {
  return dimension.values().front() < *dimension.standard;
}

/// "yes" where the magnitude is on the side of the signal from the criterion (VirtualObserver::exceeds), "different" where
/// the magnitudes differ by the criterion or more (VirtualObserver::differ). Guesses without a criterion.
VirtualResponse judge_in_words(const Judgement& judgement, const Block& block) {
  const DiscriminationDesign& design = *block.design();
  const ObserverDeclaration& observer = judgement.protocol.observer;
  const std::vector<Option>& options = judgement.question.options;
  const bool is_pair = design.surfaces() == 2;
  const std::optional<double>& criterion =
      is_pair ? observer.discrimination.different_above : observer.discrimination.yes_above;
  if (!criterion) return {ChosenOption{judgement.observer.guess(options.size())}, true};
  const bool is_signal_smaller =
      is_below_standard(*block.vary) != observer.discrimination.magnitude_decreases;
  const bool is_yes =
      is_pair
          ? judgement.observer.differ(judgement.felt[0], judgement.felt[1], std::log1p(*criterion))
          : judgement.observer.exceeds(judgement.felt[0], std::log(*criterion)) !=
                is_signal_smaller;
  const auto chosen = std::find_if(options.begin(), options.end(), [&](const Option& option) {
    return option.value == (is_yes ? design.yes : design.no);
  });
  return {ChosenOption{static_cast<std::size_t>(chosen - options.begin())}, false,
          judgement.observer.certainty()};
}

/// The surface with the greatest or the smallest magnitude of three (VirtualObserver::most_extreme), on the side on which the
/// levels are, or the one that differs from the others (VirtualObserver::odd_one).
VirtualResponse judge_three(const Judgement& judgement, const Block& block) {
  using Extreme = VirtualObserver::Extreme;
  VirtualObserver& observer = judgement.observer;
  const std::size_t chosen =
      block.design()->asks_for_odd_one
          ? observer.odd_one(judgement.felt)
          : observer.most_extreme(judgement.felt, is_below_standard(*block.vary)
                                                      ? Extreme::smallest
                                                      : Extreme::greatest);
  return {ChosenOption{chosen}, false};
}

/// In words (`judge_in_words`), of three (`judge_three`), or the surface with the greater magnitude (VirtualObserver::compare),
/// whatever the question asks for; the other one where the judgement is of performance and the level is below the standard;
/// "cannot tell", where it is an option, if the magnitudes differ by less than `unsure_within`. A parameter on which the
/// magnitude does not depend gives responses by chance.
VirtualResponse judge_discrimination(const Judgement& judgement) {
  const Block& block = judgement.protocol.blocks.at(judgement.trial.block);
  const auto* const asked = question_named(block, judgement.question.name);
  if (block.design()->has_noise()) return judge_in_words(judgement, block);
  if (block.design()->is_choice_of_three()) return judge_three(judgement, block);
  const bool chooses_less =
      asked->asks_for_less() || (asked->judgement() == DiscriminationJudgement::performance &&
                                 is_below_standard(*block.vary));
  const std::optional<double>& unsure_within =
      judgement.protocol.observer.discrimination.unsure_within;
  const double least_difference =
      asked->allow_cannot_tell && unsure_within ? std::log1p(*unsure_within) : 0.0;
  const std::optional<std::size_t> greater =
      judgement.observer.compare(judgement.felt[0], judgement.felt[1], least_difference);
  // "cannot tell" is the last option.
  if (!greater) return {ChosenOption{judgement.question.options.size() - 1}, false};
  return {ChosenOption{chooses_less ? 1 - *greater : *greater}, false,
          judgement.observer.certainty()};
}

}  // namespace

const ExperimentKind& discrimination_kind() {
  static const ExperimentKind kKind{.id = "discrimination",
                                    .name = phrase("Protocols", "discrimination"),
                                    .roles = kDiscriminationRoles,
                                    .form = ChoiceForm{},
                                    .tests = kDiscriminationTests,
                                    .item_of = item_of_discrimination,
                                    .correct_of = correct_of_discrimination,
                                    .check_block = check_block_of_discrimination,
                                    .judge = judge_discrimination,
                                    .responses = &discrimination_responses()};
  return kKind;
}

}  // namespace asperity
