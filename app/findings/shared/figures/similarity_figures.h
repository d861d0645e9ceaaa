// Makes dendrograms of dissimilarities, and the map of confusions.

#pragma once

#include <string>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Which dissimilarities a dendrogram shows.
struct TreeChoice {
  QuantityName quantity{};  ///< the cophenetic dissimilarities
  Phrase title{};
  Phrase note{};
  Phrase axis{};
  Phrase none{};  ///< where there are no dissimilarities
};
TreeChoice tree_of_confusions();
TreeChoice rated_tree();

/// Similarity by confusions, as a tree and as a map.
Figure dendrogram(const FoundNumbers& found, const TreeChoice& choice = tree_of_confusions());
Figure similarity_map(const FoundNumbers& found);

}  // namespace asperity
