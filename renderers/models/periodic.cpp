// Implements the relief of a few plane waves.

#include "renderers/models/periodic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"
#include "renderers/models/sinusoid.h"

namespace asperity {
namespace {

constexpr int kWaves = 4;

std::string name_of(const char* quantity, int wave, const char* unit = "") {
  return std::string(quantity) + std::to_string(wave) + unit;
}

/// One term of the series, as it is declared.
struct Term {
  int index = 0;  ///< from 1
  double waves_x = 0.0;
  double waves_y = 0.0;
  double cosine_m = 0.0;
  double sine_m = 0.0;
};

/// The terms that have an amplitude.
std::vector<Term> terms_of(const ParameterValues& values) {
  std::vector<Term> terms{};
  for (int wave = 1; wave <= kWaves; ++wave) {
    const Term term{.index = wave,
                    .waves_x = number_of(values, name_of("waves_x_", wave)),
                    .waves_y = number_of(values, name_of("waves_y_", wave)),
                    .cosine_m = number_of(values, name_of("cosine_amplitude_", wave, "_m")),
                    .sine_m = number_of(values, name_of("sine_amplitude_", wave, "_m"))};
    if (term.cosine_m != 0.0 || term.sine_m != 0.0) terms.push_back(term);
  }
  return terms;
}

std::optional<ParameterConflict> conflict_of_terms(const ParameterValues& values) {
  const std::vector<Term> terms = terms_of(values);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Term& term = terms[i];
    const std::vector<std::string> names{name_of("waves_y_", term.index),
                                         name_of("waves_x_", term.index)};
    if (term.waves_x == 0.0 && term.waves_y <= 0.0) {
      return ParameterConflict{
          names, phrase("Protocols", "%1 is 0 and %2 is %3; a wave needs %1 > 0, or %2 > 0.")
                     .with(names[1], names[0], number_text(term.waves_y))};
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (terms[j].waves_x != term.waves_x || terms[j].waves_y != term.waves_y) continue;
      return ParameterConflict{
          names, phrase("Protocols",
                        "The terms %1 and %2 are the same wave; give it once, with the sum of the "
                        "amplitudes.")
                     .with(std::to_string(terms[j].index), std::to_string(term.index))};
    }
  }
  return std::nullopt;
}

enum class Direction { fixed, local_normal, gradient };

Direction direction_of(const ParameterValues& values) {
  const std::string& chosen = choice_of(values, "force_direction");
  if (chosen == "local_normal") return Direction::local_normal;
  return chosen == "gradient" ? Direction::gradient : Direction::fixed;
}

class Periodic final : public ForceRenderer {
 public:
  explicit Periodic(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        direction_(direction_of(inputs.parameters)) {
    if (const auto conflict = conflict_of_terms(inputs.parameters)) {
      throw PhrasedRefusal(Phrase("periodic: %1").with(conflict->message));
    }
    const double scale = number_of(inputs.parameters, "height_scale");
    const double turn_x = 2.0 * std::numbers::pi / number_of(inputs.parameters, "period_x_m");
    const double turn_y = 2.0 * std::numbers::pi / number_of(inputs.parameters, "period_y_m");
    for (const Term& term : terms_of(inputs.parameters)) {
      waves_[count_++] = {.x_rad_per_m = term.waves_x * turn_x,
                          .y_rad_per_m = term.waves_y * turn_y,
                          .cosine_m = scale * term.cosine_m,
                          .sine_m = scale * term.sine_m};
      highest_m_ += scale * std::hypot(term.cosine_m, term.sine_m);
    }
  }

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    if (point.gain == 0.0 || point.height_m >= highest_m_) return contact_.no_contact();
    double height_m = 0.0;
    double slope_x = 0.0;
    double slope_y = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Wave& wave = waves_[i];
      const double phase_rad = wave.x_rad_per_m * point.x_m + wave.y_rad_per_m * point.y_m;
      const double cosine = std::cos(phase_rad);
      const double sine = std::sin(phase_rad);
      height_m += wave.cosine_m * cosine + wave.sine_m * sine;
      const double rise_m = wave.sine_m * cosine - wave.cosine_m * sine;
      slope_x += wave.x_rad_per_m * rise_m;
      slope_y += wave.y_rad_per_m * rise_m;
    }
    const double penetration_m = height_m - point.height_m;
    if (!(penetration_m > 0.0)) return contact_.no_contact();
    const glm::dvec3 force_N = directed_N(contact_.material().stiffness_N_per_m * penetration_m,
                                          contact_.patch().motion_scale * slope_x,
                                          contact_.patch().motion_scale * slope_y);
    return contact_.force(
        point, probe, {.texture_N = force_N, .normal_N = force_N.z, .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  struct Wave {
    double x_rad_per_m = 0.0;
    double y_rad_per_m = 0.0;
    double cosine_m = 0.0;
    double sine_m = 0.0;
  };

  glm::dvec3 directed_N(double spring_N, double slope_x, double slope_y) const noexcept {
    const glm::dvec3 uphill{-slope_x, -slope_y, 1.0};
    switch (direction_) {
      case Direction::fixed:
        break;
      case Direction::local_normal:
        return spring_N / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y) * uphill;
      case Direction::gradient:
        return spring_N * uphill;
    }
    return {0.0, 0.0, spring_N};
  }

  SurfaceContact contact_;
  Direction direction_ = Direction::fixed;
  std::array<Wave, kWaves> waves_{};
  std::size_t count_ = 0;
  double highest_m_ = 0.0;
};

TextureBand band_of_waves(const RendererInputs& inputs) {
  TextureBand band{};
  for (const Term& term : terms_of(inputs.parameters)) {
    band.per_m = std::max(
        band.per_m, inputs.patch.motion_scale *
                        std::hypot(term.waves_x / number_of(inputs.parameters, "period_x_m"),
                                   term.waves_y / number_of(inputs.parameters, "period_y_m")));
  }
  return band;
}

std::vector<Parameter> parameters_of_waves() {
  std::vector<Parameter> parameters{number_parameter(
      "height_scale", "1", 0.0, 100.0, 1.0, phrase("Models", "Factor applied to all waves"))};
  for (const char* const name : {"period_x_m", "period_y_m"}) {
    parameters.push_back(number_parameter(
        name, "m", 1e-5, 0.1, 0.002,
        phrase("Models", "Length along this axis after which the relief repeats")));
  }
  for (int wave = 1; wave <= kWaves; ++wave) {
    const std::string number = std::to_string(wave);
    parameters.push_back(
        integer_parameter(name_of("waves_x_", wave), 0.0, 8.0, static_cast<double>(wave),
                          phrase("Models", "Periods of wave %1 in period_x_m").with(number)));
    parameters.push_back(integer_parameter(
        name_of("waves_y_", wave), -8.0, 8.0, 0.0,
        phrase("Models",
               "Periods of wave %1 in period_y_m; a negative number mirrors the direction of the "
               "crests")
            .with(number)));
    for (const bool is_cosine : {true, false}) {
      parameters.push_back(
          number_parameter(name_of(is_cosine ? "cosine_amplitude_" : "sine_amplitude_", wave, "_m"),
                           "m", -0.005, 0.005, wave == 1 && !is_cosine ? 1e-4 : 0.0,
                           (is_cosine ? phrase("Models", "Cosine amplitude of wave %1")
                                      : phrase("Models", "Sine amplitude of wave %1"))
                               .with(number)));
    }
  }
  parameters.push_back(choice_parameter(
      "force_direction", {"fixed", "local_normal", "gradient"},
      phrase("Models",
             "fixed: along the normal of the plane; local_normal: along that of the relief; "
             "gradient: the negative gradient of the energy of the spring")));
  add_layer_parameters(parameters);
  return parameters;
}

}  // namespace

ForceModel periodic_model() {
  return {
      .declaration = {.id = "periodic",
                      .version = "2",
                      .summary = phrase(
                          "Models", "A relief of up to four plane waves, felt through a spring"),
                      .source =
                          "Dominguez-Ramirez, Parra-Vega (2003), Texture, roughness and shape "
                          "haptic perception of deformable virtual objects",
                      .needs_height_field = false,
                      .amplitude_parameter = "height_scale",
                      .replay_tolerance_N = 1e-9,
                      .parameters = parameters_of_waves(),
                      .conflict_among = conflict_of_terms},
      .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
        return std::make_unique<Periodic>(inputs);
      },
      .suggested_by =
          [](const HeightField& field, const Material& material) {
            const ParameterValues wave = sinusoid_model().suggested_by(field, material);
            ParameterValues suggested{{"sine_amplitude_1_m", wave.at("amplitude_m")}};
            const auto length = wave.find("wavelength_m");
            if (length != wave.end()) suggested["period_x_m"] = length->second;
            return suggested;
          },
      .conservative_with = ParameterValues{{"force_direction", std::string("gradient")}},
      .band = band_of_waves,
      .band_formula =
          "v*max over the waves of sqrt((waves_x_i/period_x_m)^2 + (waves_y_i/period_y_m)^2)"};
}

}  // namespace asperity
