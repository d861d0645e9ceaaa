// Declares autoregressive models of the vibration of a texture, and their file.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace asperity {

/// The sampling rate of every vibration model.
inline constexpr double kVibrationRate_Hz = 1000.0;

/// The acceleration of a tool that slides over a texture at one speed under one normal force [Culbertson 2014].
///
///   a_n = Σ_{j=1..p} c_j·a_{n−j} + e_n                   at 1 kHz; e_n normal noise of mean 0 and variance σ²
///
/// The coefficients c_j are stored as line spectral frequencies (analysis/signals/line_spectrum.h), because means of these, and not of
/// the c_j, are stationary.
struct VibrationModel {
  double speed_m_per_s = 0.0;
  double normal_N = 0.0;
  double variance_m2_per_s4 = 0.0;  ///< σ²; 0: silent
  std::vector<double> lines_rad{};  ///< w_1 < … < w_p, between 0 and π
};

/// A texture as models at several speeds and normal forces, all of one order.
struct VibrationModels {
  std::vector<VibrationModel> models{};
};

inline constexpr std::size_t kMostVibrationModels = 256;

/// The one-sided density of the acceleration at a frequency, 2σ²/(f_s·|1 − Σ c_j·exp(−2πi·f·j/f_s)|²), in m²/s⁴ per hertz.
double acceleration_density(const VibrationModel& model, double frequency_Hz);

/// The range of the (speed, normal force) of a set: a place p is at (p − from)·per_range, from 0 to 1 on each axis.
/// Distances between places are those of the triangulation, which therefore does not depend on units.
///
/// An axis is constant, with `per_range` 0, where the set has one value. So it is with recordings of one intended speed or
/// force, whose means differ a little: where the greatest value is below 1.1 times the least speed or 1.25 times the least
/// force, as long as the other axis tells the models apart. Otherwise these differences would decide alone which model is
/// used beyond them.
struct PlaceScale {
  Eigen::Vector2d from{0.0, 0.0};
  Eigen::Vector2d per_range{0.0, 0.0};
};
PlaceScale place_scale(const VibrationModels& set);

/// The (speed, normal force) of each model on this scale.
std::vector<Eigen::Vector2d> scaled_places(const VibrationModels& set);

/// Models that can be interpolated: 1 to 256 of one order from 1 to 32, whose numbers are in range, at places that are at least
/// 0.01 % of the range apart, and not all silent.
///
/// Errors: std::invalid_argument that begins with `name`, with the model (from 1) and the correction.
void require_models(const VibrationModels& set, const std::string& name);

/// Reads a table with the columns `speed_m_per_s normal_force_N variance_m2_per_s4 line_1_rad … line_p_rad`, tab-separated and in
/// any order (docs/formats/vibration_models.md); `name` names it in messages.
///
/// Errors: std::invalid_argument that begins with `name` and the line; as require_models.
VibrationModels vibration_models_in(std::string_view tsv, const std::string& name);

/// The table of a set, in the fewest digits that give the same numbers when read.
std::string tsv_of(const VibrationModels& set);

}  // namespace asperity
