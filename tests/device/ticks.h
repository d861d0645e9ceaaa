// The beat at which the tests of this folder call a device: 1 kHz.
#pragma once

#include <cstdint>

namespace asperity {

inline constexpr double kDt_s = 1e-3;
inline constexpr std::int64_t kTick_ns = 1'000'000;
inline constexpr std::int64_t kMillisecond_ns = 1'000'000;

}  // namespace asperity
