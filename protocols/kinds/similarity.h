// The kind "similarity".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Two surfaces are felt, and their dissimilarity (or similarity) is rated on a scale; the analysis is a configuration of the
/// surfaces in which distances correspond to dissimilarities [Kruskal 1978].
const ExperimentKind& similarity_kind();

/// What the scale of its question increases with; dissimilarity where the question does not state it.
RatedQuantity rated_quantity(const Protocol::TrialQuestionTemplate& question);

}  // namespace asperity
