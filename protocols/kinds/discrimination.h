// The kind "discrimination".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// A standard and a comparison that differs from it in one parameter are felt; one of them is chosen. The judgement
/// states what the choice means: `performance`, where the comparison is the correct response, or `comparison`, where no
/// answer is correct and the proportion of choices of the comparison is a function of its level.
const ExperimentKind& discrimination_kind();

}  // namespace asperity
