// Lists the publications that reports cite, in APA style.

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace asperity {

struct Reference {
  std::string_view key{};    ///< as in docs/references.md: "Holm 1979"
  std::string_view cited{};  ///< in the text: "Holm, 1979"
  std::string_view entry{};  ///< in the list of references
};

/// All references, in the order of the list.
std::span<const Reference> references();

/// Errors: std::out_of_range for an unknown key.
const Reference& reference(std::string_view key);

}  // namespace asperity
