// Periodic Gaussian noise of a given spectrum.

#pragma once

#include <functional>
#include <string_view>

#include "stimuli/heights/surface_makers.h"

namespace asperity {

/// A wavenumber in the plane, in cycles per metre.
struct Wavenumber {
  double x_per_m = 0.0;
  double y_per_m = 0.0;
};

/// Noise of mean 0 and RMS 1 whose amplitude spectrum is proportional to `amplitude` (the square
/// root of the power spectral density per unit area of the wavenumber plane; even in its argument,
/// not asked for the wavenumber 0). It repeats with the canvas. `stream` names its random numbers,
/// so that several in one surface are independent.
///
/// Errors: std::invalid_argument where the canvas holds no wavenumber of positive amplitude.
Heights spectral_noise(const SurfaceCanvas& canvas, std::string_view stream,
                       const std::function<double(const Wavenumber&)>& amplitude);

/// A bell over the logarithm of wavelength: 1 at `centre_m`, e^−½ at centre·e^±spread.
struct WavelengthBell {
  double centre_m = 0.0;
  double spread = 0.0;
};
double amplitude_at(const WavelengthBell& bell, double wavenumber_per_m) noexcept;

}  // namespace asperity
