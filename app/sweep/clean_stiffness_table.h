// Computes the largest clean stiffness over force models, amplitudes, wavelengths and servo rates.

#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderers/offline/clean_stiffness.h"
#include "renderers/offline/roughness_stroke.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The declaration of a table. Two tables with equal declarations have equal bytes.
struct CleanStiffnessOrder {
  std::vector<const ForceModel*> models{};  ///< of a point
  ParameterValues parameters{};             ///< as given, of all models
  double friction = 0.0;
  std::vector<double> amplitudes_m{};  ///< of a sinusoid along the stroke, half of its height
  std::vector<double> wavelengths_m{};
  std::vector<double> rates_Hz{};
  std::string device = kArmInLightHand;  ///< as given; `loop.device` has its settings
  LoopStrokes loop{};                    ///< without the rate
  CleanStiffnessSearch search{};
};

/// One combination.
struct CleanStiffnessRow {
  const ForceModel* model = nullptr;
  double amplitude_m = 0.0;
  double wavelength_m = 0.0;
  double rate_Hz = 0.0;
  CleanStiffness found{};
};

/// All combinations, the rates varying fastest and the models slowest. The texture is the sinusoid of `synth` at the wavelength;
/// a model that derives its parameters or its files from a texture derives them from it, as in a sweep.
///
/// The rows do not depend on `jobs`. nullopt if stopped. `progress` receives fractions, from any thread.
///
/// Errors: std::invalid_argument for an empty list, values that are not positive or occur twice, and a model with bodies; as
/// `clean_stiffness`, with the combination.
std::optional<std::vector<CleanStiffnessRow>> clean_stiffness_rows(
    const CleanStiffnessOrder& order, int jobs, const std::stop_token& stop,
    const std::function<void(double)>& progress);

/// `model amplitude_m wavelength_m rate_Hz clean_stiffness_N_per_m unclean_stiffness_N_per_m buzz_of_clean buzz_of_unclean
/// buzz_force_of_clean_N buzz_force_of_unclean_N status`.
Table table_of(const std::vector<CleanStiffnessRow>& rows);

/// How a table was made: JSON, `asperity.clean_stiffness/1`.
std::string declaration_of(const CleanStiffnessOrder& order);

}  // namespace asperity
