// Matches the levels of a sweep with the conditions of a protocol, to display both together.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep/sweep.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// A sweep's levels matched with the conditions of a protocol of magnitude estimation.
struct SweepBeside {
  /// By the sweep's levels, in their order: the name of the condition with which each is compared.
  /// Empty texts where the protocol has no conditions.
  std::vector<std::string> conditions{};
  /// A sentence for each difference between the sweep and the protocol: model, amplitude,
  /// stiffness, friction, spacings, and quantities that neither varies.
  std::vector<std::string> remarks{};
};

/// Compares the declarations, before anything is computed.
///
/// Conditions are matched with levels by their number: the diameter of their tool, or the target
/// force or speed of their exploration. Where one of them has none (a tool that is a mesh, a band
/// without a target), levels and conditions are matched in order, the protocol's order being that
/// of EstimationDeclaration::conditions.
///
/// `study` is the folder of the protocol's height fields; one that cannot be read becomes a remark.
///
/// Errors: std::runtime_error with a sentence: the protocol has no estimates, its conditions do not
/// differ in the quantity that the sweep varies, the numbers of levels and conditions differ, a
/// level is the number of no condition, or no spacing of the sweep lies within the protocol's.
SweepBeside sweep_beside(const SweepOrder& order, const Protocol& protocol,
                         const std::filesystem::path& study);

}  // namespace asperity
