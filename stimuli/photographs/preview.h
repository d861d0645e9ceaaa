// Declares pictures that show a relief and the steps of its computation.

#pragma once

#include <span>

#include "stimuli/heights/height_field.h"
#include "stimuli/photographs/texture_from_photograph.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// Renders the relief as a matt surface in light from the upper left. Slopes are scaled to fill the grey scale, so that
/// two reliefs of the same shape look the same at any amplitude.
GreyImage shaded_relief(const HeightField& field);

/// Renders low as dark and high as bright, stretched so that 1 % of the pixels are black and 1 % white.
GreyImage height_picture(const HeightField& field);

/// Stretches the picture linearly so that 1 % of its pixels are black and 1 % white.
GreyImage stretched(GreyImage picture);

/// Reduces the picture by averaging until its longer side has `longest_side` pixels; a smaller picture is returned
/// unchanged. A cut-off in metres has the same effect on both.
///
/// Errors: std::invalid_argument for an empty picture or a side of 0 pixels.
GreyImage scaled_to_fit(const GreyImage& picture, std::size_t longest_side);

/// Arranges the pictures side by side on white, each scaled to `rows` rows.
///
/// Errors: std::invalid_argument for no pictures, an empty one, or fewer than one row.
GreyImage side_by_side(std::span<const GreyImage> pictures, std::size_t rows);

/// Shows the steps from left to right: grey, evened (f), low-pass (g), heights (f − g), shaded relief. Each except the
/// first is stretched to the grey scale.
GreyImage texture_steps(const PhotographTexture& texture, std::size_t rows);

}  // namespace asperity
