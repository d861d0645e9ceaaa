// Declares times that publications and measurements of other programs state, for comparison.

#pragma once

#include <optional>
#include <string_view>

namespace asperity {

/// A figure and where it is stated. Points to literals.
struct QuotedTime {
  std::string_view figure{};
  std::string_view source{};
};

/// The figure for a scene of `timed_scenes`; nullopt if none is known.
std::optional<QuotedTime> quoted_time(std::string_view scene) noexcept;

}  // namespace asperity
