// Implements the relief of solid noise.

#include "renderers/models/solid_noise.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/random.h"
#include "renderers/force/gradient_noise.h"
#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"
#include "renderers/models/sinusoid.h"

namespace asperity {
namespace {

constexpr std::size_t kMostOctaves = 6;
constexpr double kDefaultOctaves = 3.0;
constexpr double kOffsets = 4096.0;  // beyond any patch, so that seeds give different pieces

/// √(Σ 4^{−o}) of the first octaves.
double rms_of_octaves(double octaves) { return std::sqrt((1.0 - std::pow(0.25, octaves)) / 0.75); }

/// One octave on the texture: the two axes of the plane in the noise, the offset and the factor of the heights.
struct Octave {
  GradientNoise noise;
  glm::dvec3 x_per_m{0.0};
  glm::dvec3 y_per_m{0.0};
  glm::dvec3 offset{0.0};
  double amplitude_m = 0.0;
};

/// The first two columns of a rotation drawn uniformly: a unit quaternion of four normal numbers.
void draw_rotation(Random random, Octave& octave) {
  const double a = random.normal();
  const double b = random.normal();
  const double c = random.normal();
  const double d = random.normal();
  const double square = a * a + b * b + c * c + d * d;
  octave.x_per_m =
      glm::dvec3(a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c)) /
      square;
  octave.y_per_m =
      glm::dvec3(2.0 * (b * c - a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d + a * b)) /
      square;
}

class SolidNoise final : public ForceRenderer {
 public:
  explicit SolidNoise(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        lateral_gain_(number_of(inputs.parameters, "lateral_gradient_gain")) {
    const double relief = number_of(inputs.parameters, "relief");
    const Random random = Random(relief > 0.0 ? static_cast<std::uint64_t>(relief) : inputs.seed)
                              .split("solid_noise");
    const auto octaves = static_cast<std::size_t>(number_of(inputs.parameters, "octaves"));
    double per_m = 1.0 / number_of(inputs.parameters, "wavelength_m");
    double amplitude_m = number_of(inputs.parameters, "amplitude_m");
    octaves_.reserve(octaves);
    for (std::size_t o = 0; o < octaves; ++o) {
      const Random own = random.split(o);
      Octave octave{.noise = GradientNoise(own.split("noise")), .amplitude_m = amplitude_m};
      draw_rotation(own.split("rotation"), octave);
      octave.x_per_m *= per_m;
      octave.y_per_m *= per_m;
      Random offsets = own.split("offset");
      for (int axis = 0; axis < 3; ++axis) octave.offset[axis] = kOffsets * offsets.uniform();
      octaves_.push_back(octave);
      per_m *= 2.0;
      amplitude_m *= 0.5;
    }
  }

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    if (point.gain == 0.0) return contact_.no_contact();
    double height_m = 0.0;
    double slope_x = 0.0;
    double slope_y = 0.0;
    for (const Octave& octave : octaves_) {
      const NoiseAtPlace noise =
          octave.noise.at(octave.offset + point.x_m * octave.x_per_m + point.y_m * octave.y_per_m);
      height_m += octave.amplitude_m * noise.value;
      slope_x += octave.amplitude_m * glm::dot(noise.gradient, octave.x_per_m);
      slope_y += octave.amplitude_m * glm::dot(noise.gradient, octave.y_per_m);
    }
    const double penetration_m = height_m - point.height_m;
    if (!(penetration_m > 0.0)) return contact_.no_contact();
    const double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const double per_slope_N = -lateral_gain_ * normal_N * contact_.patch().motion_scale;
    return contact_.force(point, probe,
                          {.texture_N = {per_slope_N * slope_x, per_slope_N * slope_y, normal_N},
                           .normal_N = normal_N,
                           .penetration_m = penetration_m},
                          dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  std::vector<Octave> octaves_{};
  double lateral_gain_ = 0.0;
};

// Less than 2 % of the power of an octave is in waves shorter than half a cell of its lattice.
TextureBand band_of_octaves(const RendererInputs& inputs) {
  return {.per_m = std::pow(2.0, number_of(inputs.parameters, "octaves")) *
                   inputs.patch.motion_scale / number_of(inputs.parameters, "wavelength_m")};
}

}  // namespace

ForceModel solid_noise_model() {
  ModelDeclaration declaration{
      .id = "solid_noise",
      .version = "1",
      .summary = phrase("Models", "A relief cut out of noise that fills space"),
      .source =
          "Fritz, Barner (1996), Stochastic models for haptic "
          "texture; Perlin (2002), Improving noise",
      .needs_height_field = false,
      .amplitude_parameter = "amplitude_m",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      number_parameter(
          "amplitude_m", "m", 0.0, 0.005, 50e-6,
          phrase(
              "Models",
              "Amplitude of the first octave; the RMS of one octave is 0.27 times its amplitude")),
      number_parameter("wavelength_m", "m", 1e-4, 0.1, 0.001,
                       phrase("Models",
                              "Cell size of the lattice of the first octave, approximately the "
                              "longest wavelength")),
      integer_parameter(
          "octaves", 1.0, static_cast<double>(kMostOctaves), kDefaultOctaves,
          phrase("Models",
                 "Number of octaves, each with half the wavelength and half the amplitude of the "
                 "previous one")),
      integer_parameter(
          "relief", 0.0, 1e6, 0.0,
          phrase("Models",
                 "Number of the relief, which is the same in every presentation; 0: a different "
                 "relief in every presentation")),
      number_parameter(
          "lateral_gradient_gain", "1", 0.0, 10.0, 0.0,
          phrase("Models",
                 "Force along the surface, -gain times normal force times slope; 1 makes the "
                 "force conservative"))};
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<SolidNoise>(inputs);
          },
          .suggested_by =
              [](const HeightField& field, const Material& material) {
                ParameterValues suggested{
                    {"amplitude_m",
                     field.rms_m() / (GradientNoise::kRms * rms_of_octaves(kDefaultOctaves))}};
                const ParameterValues wave = sinusoid_model().suggested_by(field, material);
                const auto length = wave.find("wavelength_m");
                if (length != wave.end()) suggested["wavelength_m"] = length->second;
                return suggested;
              },
          .conservative_with = ParameterValues{{"lateral_gradient_gain", 1.0}},
          .band = band_of_octaves,
          .band_formula = "v*2^octaves/wavelength_m"};
}

}  // namespace asperity
