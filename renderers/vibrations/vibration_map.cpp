// Implements the interpolation of vibration models.

#include "renderers/vibrations/vibration_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/line_spectrum.h"
#include "analysis/words/phrased_error.h"

namespace asperity {

VibrationMap::VibrationMap(const VibrationModels& set, VarianceLaw law, const std::string& name)
    : law_(law) {
  require_models(set, name);
  order_ = set.models.front().lines_rad.size();
  for (std::size_t i = 0; i < set.models.size(); ++i) {
    const VibrationModel& model = set.models[i];
    if (law == VarianceLaw::logarithmic && model.variance_m2_per_s4 == 0.0) {
      throw PhrasedRefusal(
          phrase(
              "Models",
              "%1: model %2 at %3 m/s and %4 N is silent, and the logarithm of its variance does "
              "not exist; set variance to linear")
              .with(name, std::to_string(i + 1), number_text(model.speed_m_per_s),
                    number_text(model.normal_N)));
    }
    lines_rad_.insert(lines_rad_.end(), model.lines_rad.begin(), model.lines_rad.end());
    variance_.push_back(law == VarianceLaw::logarithmic ? std::log(model.variance_m2_per_s4)
                                                        : model.variance_m2_per_s4);
  }
  const PlaceScale scale = place_scale(set);
  from_ = scale.from;
  per_range_ = scale.per_range;
  places_ = scaled_places(set);
  triangulation_ = delaunay(places_);
}

VibrationMap::Mixture VibrationMap::mixture_at(const Place& place,
                                               std::size_t& triangle) const noexcept {
  const Eigen::Vector2d at =
      (Eigen::Vector2d(place.speed_m_per_s, place.normal_N) - from_).cwiseProduct(per_range_);
  const auto& triangles = triangulation_.triangles;
  // The walk towards a place never returns to a triangle of Delaunay; rounding near a corner ends it after all of them.
  for (std::size_t steps = 0; steps < triangles.size(); ++steps) {
    const Triangulation::Triangle& here = triangles[triangle];
    Mixture mixture{.models = here.points};
    double whole = 0.0;
    std::size_t least = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d u = places_[here.points[(i + 1) % 3]] - at;
      const Eigen::Vector2d v = places_[here.points[(i + 2) % 3]] - at;
      mixture.weights[i] = u.x() * v.y() - u.y() * v.x();
      whole += mixture.weights[i];
      if (mixture.weights[i] < mixture.weights[least]) least = i;
    }
    if (!(mixture.weights[least] < 0.0)) {
      for (double& weight : mixture.weights) weight /= whole;
      return mixture;
    }
    if (here.neighbours[least] == Triangulation::kNone) return nearest_on_hull(at);
    triangle = here.neighbours[least];
  }
  return nearest_on_hull(at);
}

VibrationMap::Mixture VibrationMap::nearest_on_hull(const Eigen::Vector2d& at) const noexcept {
  Mixture mixture{};
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::array<std::size_t, 2>& side : triangulation_.hull) {
    const Eigen::Vector2d way = places_[side[1]] - places_[side[0]];
    const double part = std::clamp((at - places_[side[0]]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (places_[side[0]] + part * way - at).squaredNorm();
    if (!(distance < nearest)) continue;
    nearest = distance;
    mixture = {.models = {side[0], side[1], side[1]}, .weights = {1.0 - part, part, 0.0}};
  }
  return mixture;
}

double VibrationMap::filter_at(const Place& place, std::size_t& triangle,
                               std::span<double> coefficients) const noexcept {
  const Mixture mixture = mixture_at(place, triangle);
  std::array<double, kMostSpectralLines> lines_rad;
  const double* const a = lines_rad_.data() + order_ * mixture.models[0];
  const double* const b = lines_rad_.data() + order_ * mixture.models[1];
  const double* const c = lines_rad_.data() + order_ * mixture.models[2];
  double variance = 0.0;
  for (std::size_t k = 0; k < 3; ++k) variance += mixture.weights[k] * variance_[mixture.models[k]];
  for (std::size_t i = 0; i < order_; ++i) {
    lines_rad[i] =
        mixture.weights[0] * a[i] + mixture.weights[1] * b[i] + mixture.weights[2] * c[i];
  }
  coefficients_of_lines(std::span(lines_rad).first(order_), coefficients);
  return law_ == VarianceLaw::logarithmic ? std::exp(0.5 * variance) : std::sqrt(variance);
}

}  // namespace asperity
