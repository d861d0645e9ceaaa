// Declares the contact of a rigid body with an elastic half-space.

#pragma once

#include "renderers/elastic/cell_field.h"
#include "renderers/elastic/half_space_displacement.h"

namespace asperity {

/// Finds the loads of a frictionless contact: s ≥ 0, g = K·s − w ≥ 0 and s·g = 0 in every cell, with w the overlap of the
/// undeformed bodies [m], negative where they are apart, and s the load (half_space_displacement.h).
///
/// Method: conjugate gradients on the cells in contact; loads below 0 are set to 0, and cells with a negative gap are added
/// with a step of the same length [Polonsky 1999]. The search starts with the loads of the last call: in a servo loop
/// an iteration that was not made in one tick is made in the next. An iteration takes one convolution, and a second one if
/// cells enter or leave the contact.
///
/// The loads maximise w·s − ½s·K·s, so that the force of a solved contact is the gradient of a potential, cells included.
///
/// Real-time: no allocation, locks or exceptions; at most 2·`most_iterations` + 1 convolutions. Threads: one at a time.
class HalfSpaceContact final {
 public:
  struct Effort {
    int most_iterations = 8;
    /// The largest violation of the conditions at which the search ends, relative to the largest overlap.
    double residual = 1e-6;
  };

  /// Removes all loads.
  void clear() noexcept;

  /// The largest violation that is left: of |g| in contact, of −g elsewhere, relative to the largest overlap; 0 without
  /// contact.
  double solve(const CellField& overlap_m, const Effort& effort) noexcept;

  const CellField& load_m() const noexcept { return load_m_; }
  /// K·s, of the loads.
  const CellField& displacement_m() const noexcept { return displacement_m_; }

 private:
  void start(const CellField& overlap_m) noexcept;
  double residual_m(const CellField& overlap_m) const noexcept;
  /// One iteration; whether the next one continues its direction.
  bool step(const CellField& overlap_m, bool continues) noexcept;

  HalfSpaceDisplacement displace_{};
  CellField load_m_{};
  CellField displacement_m_{};
  CellField direction_m_{};
  CellField of_direction_m_{};
  double gap_square_m2_ = 0.0;
  bool is_loaded_ = false;
};

}  // namespace asperity
