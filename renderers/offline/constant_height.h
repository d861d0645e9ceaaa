// Declares the search for the height with a given mean normal force.

#pragma once

#include <functional>
#include <optional>

namespace asperity {

struct HeightSearch {
  double force_N = 0.0;            ///< the required mean normal force, positive
  double stiffness_N_per_m = 0.0;  ///< of the surface: scales the first steps
  double tolerance = 1e-9;         ///< of the force, relative
  int height_bits = 50;            ///< accuracy of the height, in bits
};

/// The result of the search: the height over the plane, or the closest force that was reached.
struct ConstantHeight {
  std::optional<double> height_m{};
  double reached_N = 0.0;
};

/// Searches upwards and downwards from the height for a plain plate, in growing steps up to 0.1 m, and then between two
/// heights that bracket the force. `mean_normal_N` is the mean force at a height; it need not be monotonic, but must be
/// continuous at the solution.
ConstantHeight constant_height(const std::function<double(double height_m)>& mean_normal_N,
                               const HeightSearch& search);

}  // namespace asperity
