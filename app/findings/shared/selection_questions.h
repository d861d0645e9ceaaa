// Answers the questions of a selection in sentences, from its tests and scales.

#pragma once

#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/selection_choices.h"

namespace asperity {

/// Of groups that are compared in which items they choose, of every kind with such choices.
inline constexpr TestClaim kClaimOfChosenItems{
    kGroupProfilesTest, "",
    "The proportions of choices of the items were significantly different in the groups %1 and %2",
    "",
    "The proportions of choices of the items were not significantly different in the groups %1 and "
    "%2"};

/// Of the last test, which compares how often two are chosen: holds the participants' mean proportion of choices of the first
/// against it. `of_first`: the key of this proportion, which `found` need not have.
void state_share_of_pair(const FoundNumbers& found, const FindingKey& of_first, StudyTests& tests);

/// The log worths of the items: of the Bradley–Terry model where trials offer two of them, otherwise of the Plackett–Luce model.
QuantityName scale_quantity(const Selection& selection);

/// Which rendering is chosen most often, in the words of the protocol: by the participants' proportions where every trial offers
/// every item, otherwise by the scale.
void ask_preference(const Selection& selection, const FoundNumbers& choice,
                    const FoundNumbers& scale, const StudyTests& tests, AnalysisOutcome& outcome);

/// The words in which pairs are reported, and the name of their tests.
struct PairWords {
  Phrase question{};
  Phrase method{};
  Phrase nothing_chosen{};  ///< the answer without any choice between two items
  std::string test{};
};
/// Of a selection: whether one rendering is chosen more often than another.
PairWords words_of_pairs(const Selection& selection, const std::string& test);
/// Which item of a pair is chosen more often; `found` has the differences, and the proportions of
/// single pairs where trials offer different items.
void ask_pairs(const PairWords& words, const StudyTests& tests, const FoundNumbers& found,
               AnalysisOutcome& outcome);

/// Whether the position of a surface in its trial matters. `method`: the test.
void ask_position(std::size_t positions, const Phrase& method, const FoundNumbers& found,
                  const StudyTests& tests, AnalysisOutcome& outcome);

/// Whether the proportion of choices of the target depends on the texture.
void ask_textures(const Selection& selection, const StudyTests& tests, AnalysisOutcome& outcome);
/// Whether that question applies: there is a target, offered in every trial, and several textures.
bool asks_about_textures(const Selection& selection);

}  // namespace asperity
