// What a protocol states for a similarity alone.

#pragma once

#include <optional>

namespace asperity {

/// What the scale of a similarity increases with.
enum class RatedQuantity { dissimilarity, similarity };

/// The question of a similarity.
struct SimilarityQuestion {
  std::optional<RatedQuantity> rates{};  ///< dissimilarity where it is not stated
};

}  // namespace asperity
