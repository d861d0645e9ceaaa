// What a protocol states for a rating alone.

#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace asperity {

/// Scales of ratings that are to measure the same attribute of the items: the test items of Cronbach's alpha.
struct ConstructDeclaration {
  std::vector<std::string> scales{};         ///< names of questions with a scale; at least two
  std::vector<std::string> reverse_keyed{};  ///< those of them on which the attribute decreases

  bool is_reversed(const std::string& scale) const {
    return std::find(reverse_keyed.begin(), reverse_keyed.end(), scale) != reverse_keyed.end();
  }
  bool operator==(const ConstructDeclaration&) const = default;
};

}  // namespace asperity
