// Describes how long ago something happened.

#pragma once

#include "analysis/words/phrase.h"

namespace asperity {

inline constexpr double kHoursADay = 24.0;

/// "less than an hour ago", "26 hours ago", "325 days ago": in hours up to two days, then in days. h
Phrase time_ago(double hours);

}  // namespace asperity
