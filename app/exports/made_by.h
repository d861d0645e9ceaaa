// Who gave the answers of an exported dataset.

#pragma once

#include <string>

namespace asperity {

/// Empty for people's answers that count; what the dataset says of itself where they are others.
struct MadeBy {
  std::string in_title{};  ///< behind the name of the study: " (virtual participants)"
  std::string sentence{};
};

}  // namespace asperity
