// Declares simulated photographs of surfaces with known heights, the ground truth for texture_from_photograph.h.

#pragma once

#include <cstdint>

#include "stimuli/heights/height_field.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// The cause of the brightness of a pixel.
enum class PhotographCase {
  bright_height,  ///< higher parts are brighter
  lambert,        ///< a matt surface of one colour in light from one side
  albedo,         ///< paint that is independent of the relief, in even light
};

struct PhotographSettings {
  PhotographCase photograph_case = PhotographCase::bright_height;
  double light_azimuth_rad = 0.0;      ///< of lambert: of the light source, from +x towards +y
  double light_elevation_rad = 0.785;  ///< of lambert: above the plane, in (0, π/2]
  double lamp_ratio = 1.0;  ///< the lamp's brightness at the left edge over that at the right
  double gamma = 1.0;       ///< of the camera: stored = light^(1/gamma)
  double noise_rms = 0.0;   ///< of the camera, as a fraction of white
  std::uint64_t seed = 1;   ///< of noise and paint
};

/// Renders a photograph of a surface from straight above, one pixel per sample. The light on level ground is:
///
///     bright_height  0.2 + 0.6 (h − h_min)/(h_max − h_min)
///     lambert        0.5 max(0, n·l)/sin(elevation), n the surface's unit normal, l towards the
///                    light; no cast shadows
///     albedo         0.5 + 0.15 × Gaussian noise of wavelengths around 3 mm
///
/// It is multiplied by a linear change from 1 to 1/lamp_ratio across the width and raised to the power 1/gamma; noise
/// is added and the result is clipped to [0, 1].
///
/// Errors: std::invalid_argument naming the setting, for an elevation outside (0, π/2], a lamp
/// ratio or gamma outside 1/20 to 20, noise outside 0 to 1.
GreyImage synthetic_photograph(const HeightField& surface, const PhotographSettings& settings);

}  // namespace asperity
