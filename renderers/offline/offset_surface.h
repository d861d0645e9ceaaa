// Declares the offset surface of a rigid tip over a height field along one line, and its force.

#pragma once

#include <memory>
#include <vector>

#include "renderers/force/force_model.h"
#include "stimuli/heights/height_field.h"

namespace asperity {

/// The form of the tip: a point, a ball, or an upright wheel in the plane of the stroke whose width is a tenth of its
/// height (on a relief that is constant across the stroke the ball and the wheel give the same).
enum class TipForm { point, sphere, disc };
struct RigidTip {
  TipForm form = TipForm::sphere;
  double diameter_m = 0.002;  ///< of a sphere and a disc
};

/// Stores the height of the lowest point of a tip that rests on a height field, along a line in x.
///
///   h_off(x) = max over (ξ, η) under the tip of ( h(x + ξ, y + η) − drop(ξ, η) )
///   drop     = R − √(R² − ξ² − η²) of a sphere of radius R;  R − √(R² − ξ²) for |η| ≤ R/10 of a disc
///
/// h is `gain` times the field's height. Over isolated points at a distance L a sphere follows arcs that meet in cusps;
/// it touches the ground between bumps of height h if L ≥ 2·√(2Rh − h²).
///
/// The maximum is taken over samples `pitch_m` apart along the line, or slightly less, so that the field's period is a
/// whole number of them, and at most 25 µm and two pitches apart across it.
///
/// Errors: std::invalid_argument, naming the field, for a pitch or a diameter that is not positive, for
/// Tiling::bounded, which has no period, and for more than 2²² samples in a period.
class OffsetSurface final {
 public:
  struct Sampling {
    Tiling tiling = Tiling::repeat;
    double line_m = 0.0;  ///< y of the line
    double gain = 1.0;    ///< on the heights
    double pitch_m = 0.0;
  };
  OffsetSurface(const HeightField& field, const RigidTip& tip, const Sampling& sampling);

  double pitch_m() const noexcept { return pitch_m_; }
  double period_m() const noexcept { return period_m_; }
  const std::vector<double>& heights_m() const noexcept { return heights_m_; }

 private:
  double pitch_m_ = 0.0;
  double period_m_ = 0.0;
  std::vector<double> heights_m_{};  ///< at i·pitch_m
};

/// Makes a renderer of the force of pd_gradient on a rigid tip that slides along the device's y = 0 over a patch, with
/// n the patch's +z and without a coupling:
///
///   δ = h_off(x) − (p_z − z_s),   F = −k·δ·(∂δ/∂x, 0, −1),   ∂δ/∂x = (h_off(x + s) − h_off(x − s))/2s
///
/// s is the model's `step_m` (slightly less, so that h_off is sampled s/8 apart) and k the Material's stiffness;
/// friction and contact damping are the model's. Two textured meshes of the same shapes give this force if the window
/// is wider than the contact and their samples are fine; a test compares the two. There is no torque and no force
/// across the line. The computation is thousands of times as fast, so that many strokes can be compared offline;
/// sessions render the meshes.
///
/// `inputs.height_field` is the surface, repeated according to the patch. The parameters are those of pd_gradient;
/// those of coupling, sampling and the tool's texture have no effect.
///
/// Errors: std::invalid_argument in the cases of OffsetSurface, without a height field, and with `maximum = smooth` and
/// a motion scale other than 1.
///
/// Real-time: `reset` and `tick` do not allocate, lock or throw.
std::unique_ptr<ForceRenderer> make_tip_renderer(const ForceModel& pd_gradient,
                                                 const RendererInputs& inputs, const RigidTip& tip);

}  // namespace asperity
