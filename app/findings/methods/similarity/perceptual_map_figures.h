// Makes the figures of rated dissimilarities.

#pragma once

#include <vector>

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Of rated dissimilarities: configuration, Shepard diagram, stress by dimensions, dendrogram and weights of the participants.
std::vector<Figure> perceptual_map_figures(const FoundNumbers& found);

}  // namespace asperity
