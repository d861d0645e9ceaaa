// An example of a force model in a plug-in: rounded ridges across the surface.
//
//   h = A (1 + cos(2 pi x/L))          height over the plane [m]: A = amplitude_m, L = spacing_m
//   w = max(0, h - z)                  penetration of the tip [m], z its height above the plane
//   F = k w n                          k the stiffness of the surface [N/m]
//
// n = (0, 0, 1) with the direction "normal"; with "gradient" n = (-dh/dx, 0, 1), so that F is the gradient of the energy k w^2/2.

#include <cmath>
#include <stdexcept>

#include <asperity_plugin.hpp>

namespace {

constexpr double kTwoPi = 6.283185307179586;

constexpr const char* kDirections[] = {"normal", "gradient"};

constexpr asperity_parameter kParameters[] = {
    {"amplitude_m", ASPERITY_NUMBER, "m", 0.0, 0.002, 0.0001, nullptr, 0,
     "Amplitude A: half the height from trough to crest"},
    {"spacing_m", ASPERITY_NUMBER, "m", 0.0002, 0.05, 0.002, nullptr, 0,
     "Spacing L of the ridges along x"},
    {"direction", ASPERITY_CHOICE, "1", 0.0, 0.0, 0.0, kDirections, 2,
     "normal: along the normal of the plane; gradient: the gradient of the energy of the spring"},
};

class Ridges {
 public:
  explicit Ridges(const asperity_inputs& inputs)
      : amplitude_m_(inputs.values[0]),
        wave_number_rad_per_m_(kTwoPi / inputs.values[1]),
        slopes_(inputs.values[2] == 1.0),
        stiffness_N_per_m_(inputs.stiffness_N_per_m),
        motion_scale_(inputs.motion_scale) {
    if (amplitude_m_ > inputs.values[1]) {
      throw std::invalid_argument("amplitude_m exceeds spacing_m; lower it");
    }
  }

  static asperity_band band(const asperity_inputs& inputs) {
    return {inputs.motion_scale / inputs.values[1], 0.0};
  }

  asperity_force tick(const asperity_sample& sample) const {
    const double phase_rad = wave_number_rad_per_m_ * sample.x_m;
    const double depth_m = amplitude_m_ * (1.0 + std::cos(phase_rad)) - sample.height_m;
    if (!(depth_m > 0.0)) return {};
    const double normal_N = stiffness_N_per_m_ * depth_m;
    asperity_force force{{0.0, 0.0, normal_N}, normal_N, depth_m};
    if (slopes_) {
      const double slope =
          -amplitude_m_ * wave_number_rad_per_m_ * std::sin(phase_rad) * motion_scale_;
      force.force_N[0] = -normal_N * slope;
    }
    return force;
  }

 private:
  double amplitude_m_ = 0.0;
  double wave_number_rad_per_m_ = 0.0;
  bool slopes_ = false;
  double stiffness_N_per_m_ = 0.0;
  double motion_scale_ = 1.0;
};

}  // namespace

const asperity_model* asperity_plugin_model() {
  static const asperity_model kModel = [] {
    asperity_model model{};
    model.id = "ridges";
    model.version = "1";
    model.summary = "Rounded ridges across the surface, felt through a spring";
    model.source = "Example of the guide \"Write a force model\"";
    model.parameters = kParameters;
    model.parameter_count = sizeof kParameters / sizeof kParameters[0];
    model.amplitude_parameter = "amplitude_m";
    model.band_formula = "v/spacing_m";
    return asperity_plugin::model_of<Ridges>(model);
  }();
  return &kModel;
}
