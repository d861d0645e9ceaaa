// Photographs of surfaces whose heights are known: the ground truth of texture_from_photograph.h.

#pragma once

#include <cstdint>

#include "stimuli/heights/height_field.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// Why a pixel of the picture is as bright as it is.
enum class PhotographCase {
  bright_height,  ///< what lies higher is brighter
  lambert,        ///< a matt surface of one colour in light from one side
  albedo,         ///< paint that has nothing to do with the relief, in even light
};

struct PhotographSettings {
  PhotographCase photograph_case = PhotographCase::bright_height;
  double light_azimuth_rad = 0.0;      ///< of lambert: where it comes from, from +x towards +y
  double light_elevation_rad = 0.785;  ///< of lambert: above the plane, in (0, π/2]
  double lamp_ratio = 1.0;  ///< the lamp's brightness at the left edge over that at the right
  double gamma = 1.0;       ///< of the camera: stored = light^(1/gamma)
  double noise_rms = 0.0;   ///< of the camera, as a share of white
  std::uint64_t seed = 1;   ///< of noise and paint
};

/// The picture of a surface, seen from straight above, one pixel per sample. Light on level ground:
///
///     bright_height  0.2 + 0.6 (h − h_min)/(h_max − h_min)
///     lambert        0.5 max(0, n·l)/sin(elevation), n the surface's unit normal, l towards the
///                    light; nothing throws a shadow on anything else
///     albedo         0.5 + 0.15 × Gaussian noise of wavelengths around 3 mm
///
/// then × a linear fall from 1 to 1/lamp_ratio across the width, to the power 1/gamma, plus noise,
/// clipped to [0, 1].
///
/// Errors: std::invalid_argument naming the setting, for an elevation outside (0, π/2], a lamp
/// ratio or gamma outside 1/20 to 20, noise outside 0 to 1.
GreyImage synthetic_photograph(const HeightField& surface, const PhotographSettings& settings);

}  // namespace asperity
