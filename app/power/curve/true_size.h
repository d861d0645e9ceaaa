// The true size of a test: how often it is significant in simulated studies without an effect.

#pragma once

#include <string>

#include "app/power/curve/power_tally.h"

namespace asperity {

/// A sentence without its end for a test, or a family, whose size without an effect differs from StudyTest::kLevel by more than three
/// Monte-Carlo standard errors, √(α(1 − α)/studies): the size, its interval, and whether it exceeds the level. Three, because two would
/// often be exceeded by chance among many tests and sizes. Empty where the size does not differ.
std::string true_size_text(const PowerCurve& curve, const TestAtSize& without_effect);

}  // namespace asperity
