// Declares the interpolation of vibration models over speed and normal force.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/numbers/delaunay.h"
#include "renderers/vibrations/vibration_models.h"

namespace asperity {

/// Whether the logarithm of the variance is interpolated, or the variance.
enum class VarianceLaw { logarithmic, linear };

/// Interpolates the models of a texture between their speeds and normal forces [Culbertson 2014].
///
///   w_i = Σ_k β_k·w_{k,i}                                 β the barycentric coordinates of (v, N) in its triangle
///   σ²  = exp(Σ_k β_k·log σ²_k)   or   Σ_k β_k·σ²_k
///
/// The triangles are those of Delaunay between the models, with speed and normal force as parts of their ranges. A place outside
/// their hull has the value at the nearest place of the hull, in the same coordinates. Models on a line are interpolated along
/// it; a single model is that of every place. The result is continuous everywhere, and equals a model at its place.
///
/// Errors: the constructor throws std::invalid_argument, which begins with `name`, as require_models; with
/// VarianceLaw::logarithmic also for a silent model, whose logarithm does not exist.
///
/// Real-time: `mixture_at` and `filter_at` do not allocate, lock or throw. They follow the triangles from the one of the last
/// call, which the caller keeps, and take a time in proportion to those on the way, and to the sides of the hull outside it.
class VibrationMap final {
 public:
  VibrationMap(const VibrationModels& set, VarianceLaw law, const std::string& name);

  struct Place {
    double speed_m_per_s = 0.0;
    double normal_N = 0.0;
  };
  /// Up to three models and their weights, which sum to 1 and are not negative.
  struct Mixture {
    std::array<std::size_t, 3> models{};
    std::array<double, 3> weights{1.0, 0.0, 0.0};
  };

  /// `triangle` is where the search begins, 0 at first, and where it ended.
  Mixture mixture_at(const Place& place, std::size_t& triangle) const noexcept;
  /// Writes c_1 … c_p, `order` numbers, and returns σ in m/s².
  double filter_at(const Place& place, std::size_t& triangle,
                   std::span<double> coefficients) const noexcept;
  std::size_t order() const noexcept { return order_; }

 private:
  Mixture nearest_on_hull(const Eigen::Vector2d& at) const noexcept;

  std::size_t order_ = 0;
  VarianceLaw law_ = VarianceLaw::logarithmic;
  std::vector<double> lines_rad_{};  ///< `order` of each model
  std::vector<double> variance_{};   ///< or its logarithm
  Eigen::Vector2d from_{0.0, 0.0};
  Eigen::Vector2d per_range_{0.0, 0.0};
  std::vector<Eigen::Vector2d> places_{};
  Triangulation triangulation_{};
};

}  // namespace asperity
