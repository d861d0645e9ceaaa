// The keys that only a similarity has.

#pragma once

#include "protocols/kind_keys/similarity.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

inline constexpr auto kRated = words_of<RatedQuantity>(
    {{"dissimilarity", RatedQuantity::dissimilarity, "the dissimilarity of the two surfaces"},
     {"similarity", RatedQuantity::similarity, "the similarity of the two surfaces"}});

/// Of the question.
inline constexpr auto kSimilarityQuestionKeys = owned_by(
    {"similarity"},
    keys_of(when(with_standard(member_key<&SimilarityQuestion::rates>(
                                   "rates", "Rates",
                                   "Similarity: whether the scale increases with the dissimilarity "
                                   "or with the similarity of the two surfaces.",
                                   kRated),
                               [](const ProtocolKey&) { return nlohmann::json("dissimilarity"); }),
                 kScaleOfTheKind)));

}  // namespace asperity
