// Makes the figure of a comparison of recorded and replayed forces.

#pragma once

#include <string>

#include "analysis/signals/force_difference.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// RMS of the recorded force, the compared force and their difference in the critical bands, at their geometric centres.
/// Both axes are logarithmic: a band without energy has no mark.
Figure replay_figure(const ForceDifference& pooled, const std::string& compared);

}  // namespace asperity
