// How an exported dataset states that its responses are not those of a study with human participants.

#pragma once

#include <string>

namespace asperity {

/// Empty for sessions of human participants in the mode run.
struct MadeBy {
  std::string in_title{};  ///< after the name of the study: " (virtual participants)"
  std::string sentence{};
};

}  // namespace asperity
