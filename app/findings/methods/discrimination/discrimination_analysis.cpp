// Declares the claims of the tests, and describes the task by the design and the arrangement of its surfaces.

#include "app/findings/methods/discrimination/discrimination_analysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/discrimination/discrimination_methods.h"
#include "app/findings/methods/discrimination/threshold_sentences.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"
#include "app/findings/methods/discrimination/thresholds/shown_thresholds.h"
#include "app/findings/outcome/analysis_list.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/level_words.h"
#include "app/findings/outcome/task_words.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/plan/block_design.h"
#include "protocols/plan/roughness_matching.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

constexpr std::array kDiscriminationClaims{
    TestClaim{"order", "friedman",
              "The proportions of choices of the three positions were significantly different", "",
              "The proportions of choices of the three positions were not significantly different"},
    TestClaim{"order", "",
              "The comparison was chosen significantly more often as surface A than as surface B",
              "The comparison was chosen significantly less often as surface A than as surface B",
              "The proportions of choices of the comparison as surface A and as surface B were not "
              "significantly different"},
    TestClaim{"conditions", "", "The %1 was significantly different between the conditions", "",
              "The %1 was not significantly different between the conditions"},
    TestClaim{"point_of_subjective_equality", "",
              "The point of subjective equality of the %1 was significantly above the standard",
              "The point of subjective equality of the %1 was significantly below the standard",
              "The point of subjective equality of the %1 was not significantly different from the "
              "standard"},
    TestClaim{kGroupsTest, "group_permutation_log",
              "The thresholds%5 were significantly higher in the group %1 than in the group %2",
              "The thresholds%5 were significantly lower in the group %1 than in the group %2",
              "The thresholds%5 of the groups %1 and %2 were not significantly different"},
    TestClaim{kGroupsTest, "",
              "The mean d′%5 was significantly higher in the group %1 than in the group %2",
              "The mean d′%5 was significantly lower in the group %1 than in the group %2",
              "The mean d′%5 of the groups %1 and %2 was not significantly different"}};

std::string apart_from_catch_trials(const Block& block) {
  return has_catch_trials(block) ? ", apart from catch trials" : "";
}

/// The placement of several surfaces, after "are presented" or "were presented".
std::string placement_of(const Arrangement& arrangement) {
  switch (arrangement.surfaces) {
    case Arrangement::Surfaces::sequential:
      return "one after the other";
    case Arrangement::Surfaces::side_by_side:
      return "side by side";
    case Arrangement::Surfaces::on_request:
      return "for the participant to feel in any order";
  }
  return {};
}

/// The task of a design with options in words.
std::string task_in_words(const Block& block) {
  return block.design()->surfaces() == 1
             ? std::string(
                   "yes/no task. In each trial, one surface is presented, the standard or a "
                   "comparison equally often, and the response is “yes” or “no”")
             : "same–different task. In each trial, two surfaces are presented " +
                   placement_of(block.arrangement) +
                   ", a standard and a comparison in either order, or two equal surfaces (two "
                   "standards or two comparisons), equally often, and the response is “same” or "
                   "“different”";
}

std::string paper_task_in_words(const Block& block) {
  return block.design()->surfaces() == 1
             ? std::string(
                   ", the standard or a comparison equally often, and the response was “yes” "
                   "or “no” (yes/no task).")
             : " " + placement_of(block.arrangement) +
                   ", a standard and a comparison in either order, or two equal surfaces (two "
                   "standards or two comparisons), equally often, and the response was “same” or "
                   "“different” (same–different task).";
}

/// The surfaces of a choice of three, and what is to be chosen.
std::string three_surfaces(const Block& block, const char* verb) {
  const std::string chosen =
      std::string(" and the odd one, at any position, ") + verb + " to be chosen";
  return block.design()->asks_for_odd_one
             ? ", equally often two standards and a comparison or two comparisons and a standard," +
                   chosen
             : std::string(", two standards and a comparison, at any position, and one of them ") +
                   verb + " to be chosen";
}

std::string task_of_three(const Block& block) {
  return std::string(block.design()->name) + ". In each trial, three surfaces are presented " +
         placement_of(block.arrangement) + three_surfaces(block, "is");
}

std::string paper_task_of_three(const Block& block) {
  return ' ' + placement_of(block.arrangement) + three_surfaces(block, "was") +
         (block.design()->asks_for_odd_one ? " (oddity task)."
                                           : " (three-alternative forced choice, 3AFC).");
}

std::string task_of_arrangement(const Arrangement& arrangement) {
  switch (arrangement.surfaces) {
    case Arrangement::Surfaces::sequential:
      return "two-interval forced choice. In each trial, a standard and a comparison are presented "
             "one after the other, in either order, and one of them is to be chosen";
    case Arrangement::Surfaces::side_by_side:
      return "two-alternative forced choice. In each trial, a standard and a comparison are "
             "presented side by side, on either side, and one of them is to be chosen";
    case Arrangement::Surfaces::on_request:
      return "two-alternative forced choice. In each trial, a standard and a comparison are felt "
             "in "
             "any order that the participant chooses, and one of them is to be chosen";
  }
  return {};
}

std::string paper_task_of_arrangement(const Arrangement& arrangement) {
  switch (arrangement.surfaces) {
    case Arrangement::Surfaces::sequential:
      return " one after the other, a standard and a comparison in either order, and one of them "
             "was to be chosen (two-interval forced choice, 2IFC).";
    case Arrangement::Surfaces::side_by_side:
      return " side by side, a standard and a comparison on either side, and one of them was to be "
             "chosen (two-alternative forced choice, 2AFC).";
    case Arrangement::Surfaces::on_request:
      return " in any order that the participant chose, a standard and a comparison, and one of "
             "them was to be chosen (two-alternative forced choice, 2AFC).";
  }
  return {};
}

std::string task_of_block(const Block& block) {
  const auto* const asked = judged_question(block);
  std::string text = block.design()->has_noise() ? task_in_words(block)
                     : block.design()->is_choice_of_three()
                         ? task_of_three(block)
                         : task_of_arrangement(block.arrangement);
  if (asked != nullptr) text += ": " + quoted(asked->prompt);
  if (asked == nullptr || !asked->prompt.ends_with('?')) text += '.';
  text += " The " + words_of_parameter(block.vary->parameter) + " of the standard is " +
          display_quantity(*block.vary->standard, unit_of_varied(block)) +
          "; that of the comparison " + levels_text(block, "it") + ". ";
  if (block.procedure) {
    text += "Choice of the level: " + procedure_text(block).english() + ". ";
    if (has_catch_trials(block)) {
      const std::string easy = catch_level_text(block);
      text += "In a catch trial " +
              (easy.empty() ? std::string("two standards are presented and “cannot tell” is the "
                                          "correct response")
                            : "the comparison " + easy) +
              "; no threshold is estimated from these trials. ";
    }
  }
  if (block.design()->has_noise()) {
    return text + "“" + std::string(block.design()->yes) + "” is the correct response " +
           (block.design()->surfaces() == 1 ? "to the comparison." : "to different surfaces.");
  }
  if (block.design()->asks_for_odd_one) return text + "The odd surface is the correct response.";
  return text + (asks_for_performance(block)
                     ? "The comparison is the correct response (judgement of performance)."
                     : "No response is correct or incorrect" + apart_from_catch_trials(block) +
                           " (judgement of comparison).");
}

std::string task_of_discrimination(const Protocol& protocol) {
  std::string text{};
  for (const Block* const block : discrimination_blocks(protocol)) {
    const std::string task = task_of_block(*block);
    if (text.find(task) != std::string::npos) continue;
    text += (text.empty() ? "Task: " : " Further task: ") + task;
  }
  return text.empty()
             ? "Task: in each trial, a standard and a comparison are presented, and one of "
               "them is to be chosen."
             : text;
}

std::string paper_task_of_discrimination(const Protocol& protocol) {
  const std::vector<const Block*> blocks = discrimination_blocks(protocol);
  const auto paper_task = [](const Block& block) {
    return block.design()->has_noise()            ? paper_task_in_words(block)
           : block.design()->is_choice_of_three() ? paper_task_of_three(block)
                                                  : paper_task_of_arrangement(block.arrangement);
  };
  std::string text = blocks.empty() ? paper_task_of_arrangement({}) : paper_task(*blocks.front());
  for (const Block* const block : blocks) {
    const bool is_arranged_otherwise =
        block->arrangement.surfaces != blocks.front()->arrangement.surfaces ||
        block->design() != blocks.front()->design();
    const std::string details =
        (is_arranged_otherwise
             ? " In the block " + quoted(block->name) + ", they were presented" + paper_task(*block)
             : std::string()) +
        " The " + words_of_parameter(block->vary->parameter) + " of the standard was " +
        display_quantity(*block->vary->standard, unit_of_varied(*block)) +
        "; that of the comparison " +
        (chooses_levels_from_answers(*block) ? as_possible(levels_text(*block, "it"))
                                             : in_past(levels_text(*block, "it"))) +
        ". " +
        (block->design()->has_noise()
             ? "“" + std::string(block->design()->yes) + "” was the correct response " +
                   (block->design()->surfaces() == 1 ? "to the comparison. "
                                                     : "to different surfaces. ")
         : block->design()->asks_for_odd_one
             ? std::string("The choice of the odd surface was correct. ")
         : asks_for_performance(*block)
             ? std::string("The choice of the comparison was correct. ")
             : "No response was correct or incorrect" + apart_from_catch_trials(*block) + ". ") +
        procedure_sentences(*block);
    if (text.find(details) == std::string::npos) text += details;
  }
  return text;
}

}  // namespace

const StudyAnalysis& discrimination_analysis() {
  static const StudyAnalysis kAnalysis{.kind = "discrimination",
                                       .name = phrase("Analysis", "discrimination"),
                                       .claims = kDiscriminationClaims,
                                       .task = task_of_discrimination,
                                       .task_for_paper = paper_task_of_discrimination,
                                       .fit_for_paper = paper_fit_of_discrimination,
                                       .analyze = analyze_discrimination,
                                       .test_family = test_discrimination,
                                       .shown_parameters = shown_discrimination_parameters,
                                       .estimates = thresholds_sentence};
  return kAnalysis;
}

}  // namespace asperity
