// A plug-in whose tick does not return once a hand has pressed on it in real time.

#include <cmath>

#include "asperity_plugin.hpp"

namespace {

constexpr asperity_parameter kParameters[] = {
    {"amplitude_m", ASPERITY_NUMBER, "m", 0.0, 0.001, 0.0001, nullptr, 0, "Amplitude of nothing"}};

class Endless {
 public:
  explicit Endless(const asperity_inputs& inputs) : stiffness_N_per_m_(inputs.stiffness_N_per_m) {}
  static asperity_band band(const asperity_inputs&) { return {100.0, 0.0}; }
  void reset(const asperity_sample&) { contact_ticks_ = 0; }
  asperity_force tick(const asperity_sample& sample) {
    const double depth_m = -sample.height_m;
    if (!(depth_m > 0.0)) return {};
    // Only in real time is the time between two ticks no round number: what is checked before a session is not endless.
    const bool is_real_time = std::fabs(sample.dt_s - 0.001) > 1e-9;
    volatile bool is_endless = is_real_time && ++contact_ticks_ > 100;
    while (is_endless) {
    }
    return {{0.0, 0.0, stiffness_N_per_m_ * depth_m}, stiffness_N_per_m_ * depth_m, depth_m};
  }

 private:
  double stiffness_N_per_m_ = 0.0;
  int contact_ticks_ = 0;
};

asperity_model described() {
  asperity_model model{};
  model.id = "endless";
  model.version = "1";
  model.summary = "A plate whose ticks end in an endless loop";
  model.source = "None";
  model.parameters = kParameters;
  model.parameter_count = 1;
  model.amplitude_parameter = "amplitude_m";
  model.band_formula = "100*v";
  return asperity_plugin::model_of<Endless>(model);
}

}  // namespace

const asperity_model* asperity_plugin_model() {
  static const asperity_model kModel = described();
  return &kModel;
}
