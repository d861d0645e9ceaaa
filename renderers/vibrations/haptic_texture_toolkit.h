// Declares the reading of a texture of the Penn Haptic Texture Toolkit.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "renderers/vibrations/vibration_models.h"

namespace asperity {

/// A texture of the toolkit as vibration models.
struct ToolkitTexture {
  VibrationModels set{};
  std::size_t silent = 0;  ///< models with a variance of 0
  bool has_moving_average = false;
  /// The greatest difference between a model of the file and the one that replaces it, in third octaves from 20 to 400 Hz; 0 without
  /// moving averages.
  double largest_difference_dB = 0.0;
  std::optional<double> friction{};  ///< `mu`; not part of the vibration
};

/// Reads the XML file of a texture, which the toolkit's licence does not allow us to distribute [Culbertson 2014].
///
///   a_n = −Σ A_k·a_{n−k} + g·(e_n + Σ B_k·e_{n−k})        e_n of variance `var`, at 1 kHz
///
/// Read are `AccelUnits` (m/s^2), `SpeedUnits` (mm/s), `ForceUnits` (N), `SampleRate` (1000), `mu` (from 0 to 2), `numMod` (the number
/// of models), and of each `model` `speedMod`,
/// `forceMod`, `var`, `ARlsf` (line spectral frequencies of A) and, where the texture has moving averages, `MAlsf` and `gain` (those
/// of B, and g). Triangles and lists of speeds are computed again and not read.
///
/// A model with a moving average is replaced by the autoregressive one of order 20 with the same first 20 covariances, and the
/// variance g²·`var`·σ²: it has the spectrum of the model within `largest_difference_dB`. Without a moving average the model is the
/// same, with the factor g if there is one.
///
/// Errors: std::invalid_argument that begins with `name` and the line, for another unit or rate, elements that are missing or not
/// numbers or occur twice, and frequencies that are not in increasing order; as xml_root_in and require_models.
///
/// [Culbertson 2014] Culbertson, Lopez Delgado, Kuchenbecker: One hundred data-driven haptic texture models.
ToolkitTexture toolkit_texture_in(std::string_view xml, const std::string& name);

}  // namespace asperity
