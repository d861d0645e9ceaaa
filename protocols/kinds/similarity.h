// The kind "similarity".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Two surfaces are felt, and their dissimilarity (or similarity) is rated on a scale; the analysis is a configuration of the
/// surfaces in which distances correspond to dissimilarities [Kruskal 1978].
const ExperimentKind& similarity_kind();

}  // namespace asperity
