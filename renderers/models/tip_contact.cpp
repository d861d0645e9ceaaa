// Implements a tip on a patch.

#include "renderers/models/tip_contact.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include <glm/gtc/quaternion.hpp>

namespace asperity {
namespace {

PressedTip::Relief relief_of(const RendererInputs& inputs) {
  return {.field = inputs.height_field,
          .height_scale = number_of(inputs.parameters, "height_scale"),
          .motion_scale = inputs.patch.motion_scale,
          .tiling = inputs.patch.tiling};
}

/// The derivative along an axis of the window at a cell, in units per cell; `apart` is the distance of neighbours in the field.
double slope_at(const CellField& field, std::size_t cell, std::size_t place,
                std::size_t apart) noexcept {
  const bool has_before = place > 0;
  const bool has_after = place + 1 < kCellsAcross;
  const double rise = (has_after ? field[cell + apart] : field[cell]) -
                      (has_before ? field[cell - apart] : field[cell]);
  return has_before && has_after ? 0.5 * rise : rise;
}

}  // namespace

void add_tip_parameters(std::vector<Parameter>& parameters) {
  parameters.push_back(
      number_parameter("height_scale", "1", 0.0, 100.0, 1.0,
                       phrase("Models", "Factor applied to the heights of the field")));
  parameters.push_back(choice_parameter(
      "tip", {"ball", "flat"},
      phrase("Models", "Shape of the rigid tip: a ball, or the flat end of a cylinder")));
  parameters.push_back(
      number_parameter("tip_radius_m", "m", 2e-4, 0.02, 0.003,
                       phrase("Models",
                              "Radius of the tip; the contact is computed in cells of 1/15 of "
                              "it, and texture finer than two cells is lost")));
  parameters.push_back(
      choice_parameter("tool_turns", {"fixed", "device"},
                       phrase("Models",
                              "fixed: the tip stays upright; device: it tilts with the "
                              "handle, by small angles")));
}

PressedTip::Shape tip_shape_of(const ParameterValues& parameters) {
  return {.end = choice_of(parameters, "tip") == "flat" ? TipEnd::flat : TipEnd::ball,
          .radius_m = number_of(parameters, "tip_radius_m")};
}

TextureBand band_of_tip(const RendererInputs& inputs) {
  const double cell_m = number_of(inputs.parameters, "tip_radius_m") / PressedTip::kCellsInRadius;
  const double motion = inputs.patch.motion_scale;
  return {.per_m = motion / (2.0 * std::max(inputs.height_field->grid().pitch_m, cell_m * motion))};
}

TipContact::TipContact(const RendererInputs& inputs)
    : contact_(inputs.patch, inputs.material, inputs.parameters),
      tip_(tip_shape_of(inputs.parameters), relief_of(inputs)),
      turns_(choice_of(inputs.parameters, "tool_turns") == "device") {}

void TipContact::touch(std::span<const ChartOfTip> charts) noexcept {
  chart_count_ = charts.size();
  std::copy(charts.begin(), charts.end(), charts_.begin());
}

const PressedTip::Overlap* TipContact::overlap(const ProbeState& probe) noexcept {
  point_ = contact_.locate(probe.position_m);
  if (point_.gain == 0.0) return nullptr;
  PressedTip::Pose pose{.height_m = point_.height_m};
  if (turns_) {
    const glm::dmat3 rotation = glm::mat3_cast(probe.orientation);
    pose.tilt = {rotation[0].z, rotation[1].z};
  }
  std::array<PressedTip::Place, kMostCharts> places{
      PressedTip::Place{.x_m = point_.x_m, .y_m = point_.y_m}};
  for (std::size_t i = 0; i < chart_count_; ++i) {
    const ChartOfTip& chart = charts_[i];
    const PatchPoint at = contact_.locate(glm::dvec3(chart.texture_m, 0.0));
    places[i] = {.x_m = at.x_m, .y_m = at.y_m, .turn = chart.turn, .weight = chart.weight};
  }
  const std::size_t count = std::max<std::size_t>(1, chart_count_);
  overlap_ = &tip_.overlap(pose, std::span(places).first(count));
  return overlap_;
}

RenderedTick TipContact::force(const ProbeState& probe, const CellField& load_m, double N_per_m,
                               const CellField* dent_m, double dt_s) noexcept {
  glm::dvec3 force_N(0.0);
  glm::dvec3 torque_N_m(0.0);
  const double per_cell = 1.0 / cell_m();
  for (std::size_t row = 0; row < kCellsAcross; ++row) {
    for (std::size_t column = 0; column < kCellsAcross; ++column) {
      const std::size_t cell = row * kCellsAcross + column;
      if (!(load_m[cell] > 0.0)) continue;
      glm::dvec2 slope{overlap_->slope_x[cell], overlap_->slope_y[cell]};
      if (dent_m != nullptr) {
        slope -= per_cell * glm::dvec2(slope_at(*dent_m, cell, column, 1),
                                       slope_at(*dent_m, cell, row, kCellsAcross));
      }
      const double normal_N = N_per_m * load_m[cell];
      const double x_m = cell_m() * from_centre(column);
      const double y_m = cell_m() * from_centre(row);
      force_N += normal_N * glm::dvec3(-slope, 1.0);
      torque_N_m += normal_N * glm::dvec3(y_m, -x_m, y_m * slope.x - x_m * slope.y);
    }
  }
  RenderedTick tick = contact_.force(
      point_, probe,
      {.texture_N = force_N, .normal_N = force_N.z, .penetration_m = overlap_->deepest_m}, dt_s);
  tick.wrench.torque_N_m = point_.gain * torque_N_m;
  return tick;
}

}  // namespace asperity
