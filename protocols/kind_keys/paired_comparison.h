// What a protocol states for a paired comparison alone.

#pragma once

#include <string>

namespace asperity {

/// The question of a paired comparison.
struct PairQuestion {
  /// The text of the option "tie" after those for the surfaces.
  std::string tie{};
};

}  // namespace asperity
