// A plug-in whose tick does not return once a hand has pressed on it in real time.

#include <chrono>

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
    // What is checked before a session takes much less than the time of its ticks.
    const Clock::time_point now = Clock::now();
    if (contact_ticks_++ == 0) began_ = now;
    volatile bool is_endless = contact_ticks_ > 100 && now - began_ > std::chrono::milliseconds(80);
    while (is_endless) {
    }
    return {{0.0, 0.0, stiffness_N_per_m_ * depth_m}, stiffness_N_per_m_ * depth_m, depth_m};
  }

 private:
  using Clock = std::chrono::steady_clock;

  double stiffness_N_per_m_ = 0.0;
  int contact_ticks_ = 0;
  Clock::time_point began_{};
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
