// What tests draw from that cannot count everything.

#pragma once

#include <cstdint>

namespace asperity {

/// Always the same, so that the same data give the same p. Whoever tells such a p tells it too.
inline constexpr std::uint64_t kSeedOfTests = 1;

}  // namespace asperity
