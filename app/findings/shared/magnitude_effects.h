// Reports the effects of spacing and condition on estimates: the analysis of variance and its questions.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

/// The name of the analysis of variance among findings and tables.
inline constexpr const char* kAnova = "anova";

/// The effects: the name of a test, and the key of its findings.
using EffectNames = std::array<std::pair<const char*, const char*>, 3>;
inline constexpr EffectNames kEffects{
    {{"condition", "condition"}, {"spacing", "spacing"}, {"interaction", "condition:spacing"}}};
/// Of stimuli without spacings.
inline constexpr EffectNames kEffectsOfStimuli{{{"condition", "condition"},
                                                {"stimuli", "stimulus"},
                                                {"stimuli_by_condition", "condition:stimulus"}}};

/// The quantity that is an effect's p: Greenhouse–Geisser-corrected, if the correction applies.
QuantityName p_of(const FoundNumbers& found, const std::string& effect);

void add_anova(const FoundNumbers& found, AnalysisOutcome& outcome,
               const EffectNames& effects = kEffects);
/// The tests of the effects; those of a condition only where there are several.
void add_effect_tests(const FoundNumbers& found, std::size_t conditions, const EffectNames& effects,
                      StudyTests& tests);

/// An effect and its question. `levels`: of the factor, whose order of roughness is reported; empty if it has none.
struct EffectQuestion {
  const char* name = "";
  Phrase question{};
  const char* table = "";
  std::vector<std::string> levels{};
  const EffectNames& effects = kEffects;
};

/// Whether roughness depends on a factor, or on both together.
void ask_effect(const EffectQuestion& effect, const FoundNumbers& found, const StudyTests& tests,
                AnalysisOutcome& outcome);

}  // namespace asperity
