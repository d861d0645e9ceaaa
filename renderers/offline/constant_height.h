// The height at which a surface pushes back as hard as is wanted, on average.

#pragma once

#include <functional>
#include <optional>

namespace asperity {

struct HeightSearch {
  double force_N = 0.0;            ///< the mean normal force that is wanted, positive
  double stiffness_N_per_m = 0.0;  ///< of the surface: how far to go at first
  double tolerance = 1e-9;         ///< of the force, as a share of it
  int height_bits = 50;            ///< to how many bits the height is looked for
};

/// What was found: the height over the plane, or how near the force came to what was wanted.
struct ConstantHeight {
  std::optional<double> height_m{};
  double reached_N = 0.0;
};

/// Looks up and down from where a plain plate would be, in growing steps as far as 0.1 m, and between
/// two heights on either side of the force. `mean_normal_N` answers for a height; it
/// need not be monotonous, but has to be continuous where it meets the force.
ConstantHeight constant_height(const std::function<double(double height_m)>& mean_normal_N,
                               const HeightSearch& search);

}  // namespace asperity
