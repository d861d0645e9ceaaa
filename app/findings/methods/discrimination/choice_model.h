// Models how the choices of a discrimination depend on the level, and on how the two surfaces were explored.

#pragma once

#include <vector>

#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// The table and the analysis of its findings; with several tasks the analysis is "choice_model:TASK".
inline constexpr const char* kChoiceModel = "choice_model";

/// Adds the table `choice_model`: for each task in which one of two surfaces is chosen a logistic mixed model of the choices of the comparison, with random intercepts
/// of participants,
///
///   ln(p/(1 − p)) = β₀ + β_condition + β·(value of the comparison − standard) + γ·(force_c − force_s) + δ·(speed_c − speed_s)
///                   + ε·(comparison first) + u_participant,
///
/// with the logarithm of value/standard in place of the difference where levels are ratios or decibels, and force and speed
/// the means over the contact with the comparison and with the standard. A participant who presses harder
/// on one surface changes what is felt there: γ and δ show how much of the choices this can explain. The effects are odds
/// ratios per standard deviation over the trials, and of the position. The model is that of the family `glmm` with
/// covariates, fitted as a cumulative link model of two categories, which also exists without variance between participants.
///
/// Trials in which a surface was not touched, or of versions that stored no forces, are left out; without others there is
/// no table. Effects that do not vary are left out. Exploratory, and therefore without p: the participants choose force and
/// speed themselves, and slopes that differ between participants are not in the model, so that intervals can be too narrow.
void add_choice_model(const GatheredAnswers& gathered,
                      const std::vector<DiscriminationStudy>& studies, AnalysisOutcome& outcome);

}  // namespace asperity
