// Declares the common part of the models of a tip with a size: its parameters, its overlap with the relief, its wrench.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "renderers/elastic/pressed_tip.h"
#include "renderers/force/force_model.h"
#include "renderers/force/surface_contact.h"
#include "renderers/force/tip_on_charts.h"

namespace asperity {

/// The parameters `height_scale`, `tip`, `tip_radius_m` and `tool_turns`.
void add_tip_parameters(std::vector<Parameter>& parameters);

/// The tip that complete parameters describe.
PressedTip::Shape tip_shape_of(const ParameterValues& parameters);

/// The finest waves that the cells of the tip keep.
TextureBand band_of_tip(const RendererInputs& inputs);
inline constexpr const char* kBandOfTip =
    "v/(2*the larger of the pitch of the height field and tip_radius_m/15)";

/// A tip on a patch: where it overlaps the relief, and the wrench of loads on its cells.
///
/// F = B·Σ s_i·(−∂h/∂x + ∂d/∂x, −∂h/∂y + ∂d/∂y, 1)_i and T = B·Σ r_i × (the same), with B the force of a unit of load [N/m], s the
/// loads, h the relief and d the dent of the surface before the contact. It is the gradient of the energy whose derivative with
/// respect to the overlap of a cell is B·s. T is about the tip. Friction and borders are those of SurfaceContact.
class TipContact final : public TipOnCharts {
 public:
  explicit TipContact(const RendererInputs& inputs);

  void touch(std::span<const ChartOfTip> charts) noexcept override;
  void reset() noexcept { contact_.reset(); }
  /// Places the tip. Null outside the patch.
  const PressedTip::Overlap* overlap(const ProbeState& probe) noexcept;
  RenderedTick no_contact() noexcept { return contact_.no_contact(); }
  /// The result of loads on the cells of the last overlap. `dent_m` may be null.
  RenderedTick force(const ProbeState& probe, const CellField& load_m, double N_per_m,
                     const CellField* dent_m, double dt_s) noexcept;

  double cell_m() const noexcept { return tip_.cell_m(); }
  Friction* friction() noexcept { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  PressedTip tip_;
  bool turns_ = false;
  std::array<ChartOfTip, kMostCharts> charts_{};
  std::size_t chart_count_ = 0;  ///< 0 on a plane
  PatchPoint point_{};
  const PressedTip::Overlap* overlap_ = nullptr;
};

}  // namespace asperity
