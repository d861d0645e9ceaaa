// Implements two textured bodies as a point on one relief.

#include "renderers/offline/bodies_as_relief.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <glm/vec2.hpp>

#include "renderers/offline/composed_relief.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "renderers/pd_gradient/geometry/finest_wave.h"
#include "stimuli/properties/optional_number.h"

namespace asperity {
namespace {

// Differences and means keep away from the first and the last samples of a relief.
constexpr double kCellsOfReliefBorder = 4.0;
// A body is straight between texels: differences over fewer samples of a wave would be those of the straight parts.
constexpr double kSamplesOfFinestWave = 16.0;
// Deeper than any force limit presses a point into the relief.
constexpr double kReliefDepthLimit_m = 0.05;

double in_series(double one_N_per_m, double other_N_per_m) {
  return one_N_per_m * other_N_per_m / (one_N_per_m + other_N_per_m);
}

}  // namespace

BodiesAsRelief bodies_as_relief(const RendererInputs& bodies, const ReliefStroke& stroke,
                                const ModelRegistry& models) {
  const ParameterValues& own = bodies.parameters;
  const GainedBody tool{.mesh = *bodies.tool,
                        .gain = optional_number(own, "tool_texture_gain").value_or(1.0)};
  const GainedBody surface{.mesh = *bodies.surface,
                           .gain = optional_number(own, "texture_gain").value_or(1.0)};
  BodiesAsRelief relief{};
  relief.point = models.find("height_map");
  if (relief.point == nullptr) {
    throw std::runtime_error(
        "the force model height_map is missing; register it with the other models");
  }
  RendererInputs& inputs = relief.inputs;
  inputs.material = bodies.material;
  inputs.patch = bodies.patch;
  const double finest_m =
      std::min(finest_wave_m(tool.mesh, tool.gain), finest_wave_m(surface.mesh, surface.gain));
  inputs.height_field = std::make_shared<const HeightField>(composed_relief(
      tool, surface,
      {.length_m = stroke.length_m,
       .direction_rad = stroke.direction_rad,
       .cell_m = optional_number(own, "cell_m").value_or(TipStroke{}.cell_m),
       .pitch_m = std::isfinite(finest_m) ? finest_m / kSamplesOfFinestWave : 0.0}));
  inputs.parameters =
      complete_values(relief.point->declaration,
                      {{"lateral_gradient_gain", 1.0}, {"depth_limit_m", kReliefDepthLimit_m}});
  if (std::isfinite(finest_m)) {
    relief.waves = {.amplitude_m = std::numbers::sqrt2 * inputs.height_field->rms_m(),
                    .wavelength_m = finest_m};
  }
  relief.contact_damping_N_s_per_m = number_of(own, "contact_damping_N_s_per_m");
  if (has_virtual_coupling(own)) {
    relief.coupling = {.stiffness_N_per_m = number_of(own, "coupling_stiffness_N_per_m"),
                       .damping_N_s_per_m = number_of(own, "coupling_damping_N_s_per_m")};
  }
  return relief;
}

std::optional<FeltStiffness> felt_stiffness(const BodiesAsRelief& relief, double force_limit_N) {
  const HeightField& field = *relief.inputs.height_field;
  const double pitch_m = field.grid().pitch_m;
  const double length_m = std::max(field.width_m() - kCellsOfReliefBorder * pitch_m, 0.0);
  return felt_stiffness(*relief.point, relief.inputs,
                        {.force_limit_N = force_limit_N,
                         .extent_m = glm::dvec2(length_m, 0.0),
                         .step_m = 0.5 * pitch_m});
}

double texture_force_rms_N(const BodiesAsRelief& relief, const TextureForcePath& path) {
  RendererInputs inputs = relief.inputs;
  if (relief.coupling) {
    inputs.material.stiffness_N_per_m =
        in_series(inputs.material.stiffness_N_per_m, relief.coupling->stiffness_N_per_m);
  }
  const HeightField& field = *inputs.height_field;
  TextureForcePath within = path;
  within.duration_s =
      (field.width_m() - kCellsOfReliefBorder * field.grid().pitch_m) / path.speed_m_per_s;
  within.dropped_s = 0.0;
  return texture_force_rms_N(*relief.point, inputs, within);
}

}  // namespace asperity
