// Declares the conversion of a measured surface into a height field.

#pragma once

#include <cstddef>
#include <string>

#include "stimuli/heights/height_field.h"
#include "stimuli/measured/measured_surface.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// The form that is subtracted from the heights: the least-squares plane of the measured points, or only their mean.
enum class SurfaceForm { plane, mean };

/// The relief of a measured surface, and what the conversion did.
struct SurfaceRelief {
  HeightField field;
  std::size_t points = 0;   ///< of the measurement
  std::size_t missing = 0;  ///< of these, the filled ones
  double slope_x = 0.0;     ///< of the subtracted plane, ∂h/∂x; 0 for SurfaceForm::mean
  double slope_y = 0.0;     ///< ∂h/∂y, upwards
  bool is_resampled = false;
};

/// Converts a measured surface into a height field, in four steps:
///
/// 1. The form is fitted to the measured points by least squares and subtracted.
/// 2. Missing points are filled with the solution of Laplace's equation, whose boundary values are the measured neighbours: each
///    filled height is the mean of its neighbours within the grid (up to four). It is found by successive over-relaxation,
///    until no height changes by more than 10⁻⁶ of the RMS of the measured heights, or after 1000 passes.
/// 3. If the distances of points along x and y differ by more than 10⁻⁴, the axis with the larger distance is resampled at the
///    smaller one by bicubic convolution (HeightField). Otherwise the distance along x is used for both.
/// 4. The mean is subtracted, so that the mean of the field is 0.
///
/// Errors: std::invalid_argument that begins with `name`, if fewer than half of the points are measured, if they do not
/// determine a plane, or if resampling would exceed the bounds of `MeasuredSurface`.
SurfaceRelief surface_relief(MeasuredSurface surface, SurfaceForm form, const std::string& name);

/// The parameters of the provenance of such a height field (docs/formats/height_field.md).
ParameterValues parameter_values(const MeasuredSurface& surface, SurfaceForm form,
                                 const SurfaceRelief& relief);

}  // namespace asperity
