// Whether a sweep can stand beside the estimates of a protocol, and which level beside which condition.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep/sweep.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// A sweep's levels among the conditions of a protocol of magnitude estimation.
struct SweepBeside {
  /// By the sweep's levels, in their order: the condition that each is compared with, as the protocol
  /// calls it. Empty texts where the protocol has no conditions.
  std::vector<std::string> conditions{};
  /// A sentence for each thing in which the sweep is another experiment than the protocol: model, amplitude,
  /// stiffness, friction, spacings, and what neither varies.
  std::vector<std::string> remarks{};
};

/// Looks at what is declared, before anything is computed.
///
/// Conditions are compared with levels by the number that they carry: the diameter of their tool, or the
/// force or the speed that their exploration aims at. Where one of them carries none (a tool that is a
/// mesh, a band without a target), level and condition go together in the order of both, the protocol's
/// being that of EstimationDeclaration::conditions.
///
/// `study` is the folder in which the protocol's height fields lie; one that cannot be read is a remark.
///
/// Errors: std::runtime_error with a sentence: the protocol estimates nothing, its conditions do not
/// differ in what the sweep varies, there are not as many levels as conditions, a level is the number of
/// none of them, no spacing of the sweep lies among the protocol's.
SweepBeside sweep_beside(const SweepOrder& order, const Protocol& protocol,
                         const std::filesystem::path& study);

}  // namespace asperity
