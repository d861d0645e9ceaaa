// Declares the fit of vibration models to a recorded texture.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "renderers/recordings/texture_recording.h"
#include "renderers/vibrations/vibration_models.h"

namespace asperity {

/// The mass by which a force of the texture is an acceleration of the tool, and which turns it into a force again. That of the
/// handle of a Phantom Omni with the hand's contribution; own choice.
inline constexpr double kEffectiveMass_kg = 0.05;

/// The greatest order that is tried, which is the greatest of the published models.
inline constexpr std::size_t kMostFittedOrder = 20;

struct VibrationFitSettings {
  double effective_mass_kg = kEffectiveMass_kg;
  std::optional<std::size_t> order{};  ///< 1 to kMostSpectralLines; chosen by BIC if absent
};

/// Strokes that one model describes.
struct FittedStrokes {
  std::size_t strokes = 0;
  std::size_t samples = 0;    ///< at 1 kHz
  double rms_m_per_s2 = 0.0;  ///< of the acceleration
};

struct VibrationFit {
  VibrationModels set{};
  std::vector<FittedStrokes> strokes{};  ///< of each model
  std::size_t order = 0;
};

/// Fits an autoregressive model to the strokes of each speed and normal force of a recording.
///
/// Strokes whose speeds differ by less than 10 % and whose normal forces differ by less than 25 % have one model, at the means of
/// both. Each stroke is resampled at 1 kHz (band-limited; a stroke at 1 kHz keeps its samples), its trend removed, and divided by
/// the effective mass. The coefficients are Burg's for all strokes of a model together. σ² is such that the model has the mean
/// square of the strokes.
///
/// A vibration without noise, such as a pure wave, would have poles on the circle, and means of the lines of such models a size
/// that has nothing to do with theirs. Where a reflection coefficient is above 0.9999 in magnitude (of a resonance: narrower than
/// 0.02 Hz, that is, longer than 20 s), white noise of 10⁻⁴ of the variance is therefore added to the covariances. It would
/// broaden other resonances, whose σ² can be as small a part of the variance.
///
/// All models have one order p, the one from 1 to 20 with the least
///
///   BIC(p) = Σ_k (n_k·log σ²_k(p) + p·log n_k)            n_k samples of model k, σ²_k(p) Burg's variance of order p
///
/// [Schwarz 1978]. The smallest order is taken of equal ones.
///
/// Errors: std::invalid_argument that begins with `name`, for recordings below 1 kHz, strokes of fewer than 64 samples at
/// 1 kHz, strokes without vibration, more than 256 models; as require_strokes.
///
/// [Schwarz 1978] Schwarz: Estimating the dimension of a model.
VibrationFit fitted_vibrations(const TextureRecording& recording, const std::string& name,
                               const VibrationFitSettings& settings = {});

}  // namespace asperity
