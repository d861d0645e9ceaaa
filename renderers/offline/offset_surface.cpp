// Implements the offset surface as a table over one period, and the forces from it.

#include "renderers/offline/offset_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"
#include "device/refusal.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

constexpr std::size_t kMostSamples = std::size_t{1} << 22;
constexpr double kWidestRow_m = 25e-6;
constexpr double kDiscWidth = 0.1;          // relative to its diameter
constexpr std::ptrdiff_t kCellsInStep = 8;  // of the table, in the step of the differences

double period_of(const HeightField& field, Tiling tiling) {
  switch (tiling) {
    case Tiling::repeat:
      return field.width_m();
    case Tiling::mirror:
      return 2.0 * field.width_m();
    case Tiling::bounded:
      break;
  }
  throw std::invalid_argument(
      "tiling is Tiling::bounded; an offset surface needs a tiling that repeats");
}

bool changes_across(const HeightField& field) {
  const std::size_t columns = field.grid().columns;
  const std::vector<float>& heights_m = field.heights_m();
  for (std::size_t i = columns; i < heights_m.size(); ++i) {
    if (heights_m[i] != heights_m[i % columns]) return true;
  }
  return false;
}

// The greatest distance across the line at which the tip can touch, given the height of the relief: a part of the tip
// that is higher than the relief cannot contain the maximum.
double reach_m(const RigidTip& tip, double relief_m) {
  const double radius_m = 0.5 * tip.diameter_m;
  const double deepest_m = std::min(relief_m, radius_m);
  return std::sqrt(deepest_m * (2.0 * radius_m - deepest_m));
}

// Samples of the relief along one line, extended by the width of the tip on both sides of the period.
std::vector<double> line_of(const HeightField& field, const OffsetSurface::Sampling& sampling,
                            double y_m, std::size_t period, std::size_t beyond) {
  std::vector<double> line_m(period + 2 * beyond);
  for (std::size_t i = 0; i < line_m.size(); ++i) {
    const double x_m = (static_cast<double>(i) - static_cast<double>(beyond)) * sampling.pitch_m;
    line_m[i] = sampling.gain * field.sample(x_m, sampling.line_m + y_m, sampling.tiling).height_m;
  }
  return line_m;
}

}  // namespace

OffsetSurface::OffsetSurface(const HeightField& field, const RigidTip& tip,
                             const Sampling& sampling) {
  require_positive("pitch_m", sampling.pitch_m);
  period_m_ = period_of(field, sampling.tiling);
  const double samples = std::ceil(period_m_ / sampling.pitch_m);
  if (samples > static_cast<double>(kMostSamples)) {
    throw std::invalid_argument("pitch_m is " + number_text(sampling.pitch_m) +
                                ", and a period of " + number_text(period_m_) +
                                " m would have too many samples; increase pitch_m");
  }
  const auto period = static_cast<std::size_t>(samples);
  pitch_m_ = period_m_ / samples;
  const Sampling fitted{.tiling = sampling.tiling,
                        .line_m = sampling.line_m,
                        .gain = sampling.gain,
                        .pitch_m = pitch_m_};
  if (tip.form == TipForm::point) {
    heights_m_ = line_of(field, fitted, 0.0, period, 0);
    return;
  }
  require_positive("RigidTip::diameter_m", tip.diameter_m);
  const double radius_m = 0.5 * tip.diameter_m;
  const double within_m = reach_m(tip, sampling.gain * (field.maximum_m() - field.minimum_m()));
  const auto beyond = static_cast<std::size_t>(within_m / pitch_m_);
  const double half_width_m =
      tip.form == TipForm::disc ? std::min(within_m, 0.5 * kDiscWidth * tip.diameter_m) : within_m;
  const double row_m = std::min(kWidestRow_m, 2.0 * pitch_m_);
  const std::ptrdiff_t rows =
      changes_across(field) ? static_cast<std::ptrdiff_t>(half_width_m / row_m) : 0;
  heights_m_.assign(period, -std::numeric_limits<double>::infinity());
  for (std::ptrdiff_t row = -rows; row <= rows; ++row) {
    const double y_m = static_cast<double>(row) * row_m;
    const double across_m = tip.form == TipForm::disc ? 0.0 : y_m;
    const std::vector<double> line_m = line_of(field, fitted, y_m, period, beyond);
    for (std::size_t offset = 0; offset <= 2 * beyond; ++offset) {
      const double along_m = (static_cast<double>(offset) - static_cast<double>(beyond)) * pitch_m_;
      const double height2_m2 = radius_m * radius_m - along_m * along_m - across_m * across_m;
      if (height2_m2 < 0.0) continue;
      const double drop_m = radius_m - std::sqrt(height2_m2);
      const double* from_m = line_m.data() + offset;
      for (std::size_t i = 0; i < period; ++i) {
        heights_m_[i] = std::max(heights_m_[i], from_m[i] - drop_m);
      }
    }
  }
}

namespace {

class TipOnField final : public ForceRenderer {
 public:
  TipOnField(const RendererInputs& inputs, const RigidTip& tip)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        damping_N_s_per_m_(number_of(inputs.parameters, "contact_damping_N_s_per_m")) {
    const OffsetSurface surface(*inputs.height_field, tip,
                                {.tiling = inputs.patch.tiling,
                                 .line_m = -inputs.patch.centre_m.y,
                                 .gain = number_of(inputs.parameters, "texture_gain"),
                                 .pitch_m = number_of(inputs.parameters, "step_m") / kCellsInStep});
    const auto count = static_cast<std::ptrdiff_t>(surface.heights_m().size());
    cells_per_m_ = 1.0 / surface.pitch_m();
    period_m_ = surface.period_m();
    const auto height_m = [&](std::ptrdiff_t i) {
      return surface.heights_m()[static_cast<std::size_t>((i % count + count) % count)];
    };
    table_.resize(static_cast<std::size_t>(count) + 1);
    for (std::ptrdiff_t i = 0; i <= count; ++i) {
      table_[static_cast<std::size_t>(i)] = {
          .height_m = height_m(i),
          .slope = (height_m(i + kCellsInStep) - height_m(i - kCellsInStep)) /
                   (2.0 * kCellsInStep * surface.pitch_m())};
    }
  }

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const Entry surface = at(point.x_m);
    const double depth_m = surface.height_m - point.height_m;
    if (point.gain == 0.0 || !(depth_m > 0.0)) return contact_.no_contact();
    const double stiffness_N_per_m = contact_.material().stiffness_N_per_m;
    const double rate_m_per_s = surface.slope * probe.velocity_m_per_s.x - probe.velocity_m_per_s.z;
    const double push_N =
        std::max(0.0, stiffness_N_per_m * depth_m + damping_N_s_per_m_ * rate_m_per_s);
    return contact_.force(point, probe,
                          {.texture_N = {-push_N * surface.slope, 0.0, push_N},
                           .normal_N = stiffness_N_per_m * depth_m,
                           .penetration_m = depth_m},
                          dt_s);
  }

 private:
  struct Entry {
    double height_m = 0.0;
    double slope = 0.0;
  };

  // Interpolates linearly between entries.
  Entry at(double x_m) const noexcept {
    const double cell = (x_m - period_m_ * std::floor(x_m / period_m_)) * cells_per_m_;
    const auto i = std::min(static_cast<std::size_t>(cell), table_.size() - 2);
    const double part = cell - static_cast<double>(i);
    const Entry& a = table_[i];
    const Entry& b = table_[i + 1];
    return {.height_m = a.height_m + part * (b.height_m - a.height_m),
            .slope = a.slope + part * (b.slope - a.slope)};
  }

  SurfaceContact contact_;
  double damping_N_s_per_m_ = 0.0;
  double cells_per_m_ = 0.0;
  double period_m_ = 0.0;
  std::vector<Entry> table_{};  ///< one entry more than a period
};

}  // namespace

std::unique_ptr<ForceRenderer> make_tip_renderer(const ForceModel& pd_gradient,
                                                 const RendererInputs& inputs,
                                                 const RigidTip& tip) {
  if (!inputs.height_field) {
    throw std::invalid_argument("a tip needs a height field on which it slides; give it one");
  }
  RendererInputs complete = inputs;
  complete.parameters = complete_values(pd_gradient.declaration, inputs.parameters);
  if (choice_of(complete.parameters, "maximum") != "hard") {
    throw std::invalid_argument(
        "the offset surface of a tip requires the hard maximum; set maximum to hard");
  }
  if (inputs.patch.motion_scale != 1.0) {
    throw std::invalid_argument("SurfacePatch::motion_scale is " +
                                number_text(inputs.patch.motion_scale) +
                                "; it must be 1 for pd_gradient");
  }
  return std::make_unique<TipOnField>(complete, tip);
}

}  // namespace asperity
