// The kind "discrimination".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// A standard and a comparison that differs from it in one parameter. The design states what a trial presents and how a
/// response is given (DiscriminationDesign): one of two or three surfaces is chosen, or the response is "yes" or "no" to one
/// surface, or "same" or "different" to two. The judgement states what the choice means: `performance`, where one response is correct,
/// or `comparison`, where no answer is correct and the proportion of choices of the comparison is a function of its
/// level.
const ExperimentKind& discrimination_kind();

}  // namespace asperity
