// What a protocol states for a recognition alone.

#pragma once

#include <string>

namespace asperity {

/// The question of a recognition.
struct RecognitionQuestion {
  std::string correct_factor{};  ///< the factor with the correct picture
};

}  // namespace asperity
