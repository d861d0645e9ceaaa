// Declares periodic Gaussian noise with a given spectrum.

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

/// Generates noise of mean 0 and RMS 1 whose amplitude spectrum is proportional to `amplitude` (the square root of the
/// power spectral density per unit area of the wavenumber plane; an even function, not evaluated at wavenumber 0). The
/// period is the canvas. `stream` names the stream of random numbers, so that several noises in one surface are
/// independent.
///
/// Errors: std::invalid_argument if no wavenumber of the canvas has a positive amplitude.
Heights spectral_noise(const SurfaceCanvas& canvas, std::string_view stream,
                       const std::function<double(const Wavenumber&)>& amplitude);

/// A Gaussian over the logarithm of wavelength: 1 at `centre_m`, e^−½ at centre·e^±spread.
struct WavelengthBell {
  double centre_m = 0.0;
  double spread = 0.0;
};
double amplitude_at(const WavelengthBell& bell, double wavenumber_per_m) noexcept;

}  // namespace asperity
