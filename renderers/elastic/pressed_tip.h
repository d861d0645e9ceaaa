// Declares the rigid tip of a tool over a relief, in the window of an elastic contact.

#pragma once

#include <memory>
#include <span>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "renderers/elastic/cell_field.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

enum class TipEnd {
  ball,  ///< the paraboloid r²/(2R)
  flat,  ///< the flat end of a cylinder of radius R
};

/// Computes the overlap of a rigid tip with a relief: w = h − h_A − z in the cells around the tip.
///
/// The window is centred at the tip and does not turn with it; its cells have the side R/15, so that it holds the whole face of
/// a flat end and the contact of a ball up to a radius of R. The height of the relief in a cell is its mean over the cell: a
/// wave of length λ keeps sinc(c/λ) of its amplitude along an axis, 90 % at four cells. A tilted tip is linearised: the plane
/// z = R_zx·x + R_zy·y of its rotation R is added to h_A.
///
/// The relief is that of one place of the texture, or the weighted mean of several: h(X) = Σ wᵢ·hᵢ(xᵢ + Tᵢ·X), with Tᵢ the turn
/// from the axes of the window into those of the texture.
///
/// Units and frame: metres, in the axes of the window; `height_m` is the height of the tip over the plane of the relief.
///
/// Real-time: `overlap` does not allocate, lock or throw. Heights are read only where the tip can reach them.
class PressedTip final {
 public:
  static constexpr double kCellsInRadius = 15.0;

  struct Shape {
    TipEnd end = TipEnd::ball;
    double radius_m = 0.003;
  };
  struct Relief {
    std::shared_ptr<const HeightField> field{};
    double height_scale = 1.0;
    double motion_scale = 1.0;  ///< on the texture per distance of the tip
    Tiling tiling = Tiling::repeat;
  };
  struct Pose {
    double height_m = 0.0;
    glm::dvec2 tilt{0.0};  ///< R_zx and R_zy
  };
  struct Place {
    double x_m = 0.0;  ///< on the texture
    double y_m = 0.0;
    glm::dmat2 turn{1.0};
    double weight = 1.0;
  };
  struct Overlap {
    CellField depth_m{};  ///< w; negative where the bodies are apart
    CellField slope_x{};  ///< ∂h/∂x along the motion of the tip, where w may be positive
    CellField slope_y{};
    double deepest_m = 0.0;  ///< the largest w, or 0
  };

  PressedTip(const Shape& shape, const Relief& relief);

  double cell_m() const noexcept { return cell_m_; }
  const Overlap& overlap(const Pose& pose, std::span<const Place> places) noexcept;

 private:
  Relief relief_{};
  double cell_m_ = 0.0;
  double highest_m_ = 0.0;  ///< an upper bound of the relief
  CellField profile_m_{};   ///< h_A
  Overlap found_{};
};

/// The heights of a field as their means over squares of the given side, sampled as the field is. Squares of at most a pitch
/// leave a field unchanged.
std::shared_ptr<const HeightField> means_over_squares(std::shared_ptr<const HeightField> field,
                                                      double side_m, Tiling tiling);

}  // namespace asperity
