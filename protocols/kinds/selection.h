// The kind "selection".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Which of several renderings of one texture is the most realistic: a choice among the surfaces felt. No
/// response is correct or incorrect.
const ExperimentKind& selection_kind();

}  // namespace asperity
