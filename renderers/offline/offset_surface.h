// A rigid tip over a height field, along one line: what its lowest point follows, and the force.

#pragma once

#include <memory>
#include <vector>

#include "renderers/force/force_model.h"
#include "stimuli/heights/height_field.h"

namespace asperity {

/// What touches: a point, a ball, or a wheel a tenth as wide as high that stands upright in the plane
/// of the stroke (of a relief that does not change across the stroke both feel the same).
enum class TipForm { point, sphere, disc };
struct RigidTip {
  TipForm form = TipForm::sphere;
  double diameter_m = 0.002;  ///< of a sphere and a disc
};

/// How high the lowest point of a tip stands while it rests on a height field, over a line along x.
///
///   h_off(x) = max over (ξ, η) under the tip of ( h(x + ξ, y + η) − drop(ξ, η) )
///   drop     = R − √(R² − ξ² − η²) of a sphere of radius R;  R − √(R² − ξ²) for |η| ≤ R/10 of a disc
///
/// with h `gain` times the field's heights. Over isolated points L apart a sphere follows arcs that meet
/// in cusps; it touches the ground between bumps of height h from L = 2·√(2Rh − h²) on.
///
/// The maximum is taken over samples `pitch_m` apart along the line, or a little less, so that a whole
/// number of them is the field's period, and at most 25 µm and two pitches apart across it.
///
/// Errors: std::invalid_argument, naming the field: a pitch or a diameter that is not positive,
/// Tiling::bounded, which has no period, and more than 2²² samples in a period.
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

/// The force of pd_gradient on a rigid tip that slides along the device's y = 0 over a patch, with n the
/// patch's +z, without a coupling:
///
///   δ = h_off(x) − (p_z − z_s),   F = −k·δ·(∂δ/∂x, 0, −1),   ∂δ/∂x = (h_off(x + s) − h_off(x − s))/2s
///
/// with s the model's `step_m` (a little less, so that h_off is sampled s/8 apart), k the Material's
/// stiffness, friction and contact damping as the model has them. It is what two textured meshes of
/// the same shapes come to where the window is wider than the contact and their samples are fine: a
/// test compares the two. No torque, no force across the line. Thousands of times as fast, so that
/// many strokes can be compared offline; sessions render the meshes.
///
/// `inputs.height_field` is the surface, repeated as the patch says; parameters as of pd_gradient, of
/// which those of coupling, sampling and the tool's texture have no meaning here.
///
/// Errors: std::invalid_argument as OffsetSurface has them, without a height field, with
/// `maximum = smooth` and a motion scale other than 1.
///
/// Real-time: `reset` and `tick` do not allocate, lock or throw.
std::unique_ptr<ForceRenderer> make_tip_renderer(const ForceModel& pd_gradient,
                                                 const RendererInputs& inputs, const RigidTip& tip);

}  // namespace asperity
