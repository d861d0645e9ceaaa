// Pictures for people: what a relief and the steps of its making look like.

#pragma once

#include <span>

#include "stimuli/heights/height_field.h"
#include "stimuli/photographs/texture_from_photograph.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// The relief as a matt surface in light from the upper left. Exaggerated until its slopes fill the
/// grey scale, so that two reliefs of the same shape look alike whatever their amplitude.
GreyImage shaded_relief(const HeightField& field);

/// Low is dark and high is bright, stretched so that 1 % of the pixels end up black and 1 % white.
GreyImage height_picture(const HeightField& field);

/// The picture with 1 % of its pixels black, 1 % white and the rest in proportion.
GreyImage stretched(GreyImage picture);

/// The picture averaged down until its longer side has `longest_side` pixels; as it is where it is
/// no larger. A cut-off in metres means the same on both.
///
/// Errors: std::invalid_argument for an empty picture or no pixels asked for.
GreyImage scaled_to_fit(const GreyImage& picture, std::size_t longest_side);

/// The pictures beside each other on white, each scaled to that many rows.
///
/// Errors: std::invalid_argument for no pictures, an empty one, or fewer than one row.
GreyImage side_by_side(std::span<const GreyImage> pictures, std::size_t rows);

/// The steps from left to right: grey, evened (f), low-pass (g), heights (f − g), shaded relief.
/// Each but the first is stretched to the grey scale.
GreyImage texture_steps(const PhotographTexture& texture, std::size_t rows);

}  // namespace asperity
