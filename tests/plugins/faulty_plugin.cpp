// A plug-in with one fault, chosen by FAULT when it is compiled: what the program has to refuse, or to stop.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <unistd.h>
#include <vector>

#include "asperity_plugin.hpp"

#define FAULT_none 0
#define FAULT_version 1
#define FAULT_symbol 2
#define FAULT_exception 3
#define FAULT_uncaught 4
#define FAULT_nan 5
#define FAULT_slow 6
#define FAULT_allocates 7
#define FAULT_late 8
#define FAULT_description 9
#define FAULT_taken 10
#define FAULT_anew 11
#define FAULT_latin1 12
#define FAULT_rebuilt 13
#define FAULT_crash 14
#define FAULT_unit 15
#define FAULT_stroke 16
#define FAULT_assertion 17
#define FAULT_hang 18
#define FAULT_exits 19
#define FAULT_quits 20
#define FAULT_quits_loading 21
#define FAULT_huge 22
#define FAULT_endless 23
#define IS(fault) (FAULT == FAULT_##fault)

namespace {

constexpr asperity_parameter kParameters[] = {{"amplitude_m", ASPERITY_NUMBER,
                                               IS(unit) ? "mm" : "m", 0.0, 0.001, 0.0001, nullptr,
                                               0, "Amplitude of nothing"}};

class Faulty {
 public:
  explicit Faulty(const asperity_inputs& inputs)
      : stiffness_N_per_m_(inputs.stiffness_N_per_m), amplitude_m_(inputs.values[0]) {
    if (IS(quits)) _exit(0);
  }
  static asperity_band band(const asperity_inputs&) { return {100.0, 0.0}; }
  void reset(const asperity_sample&) { ticks_ = contact_ticks_ = 0; }
  asperity_force tick(const asperity_sample& sample) {
    // Only in the two seconds in which the time is measured.
    if (IS(slow) && ++ticks_ > 900 && sample.dt_s > 0.0009) wait();
    const double depth_m = -sample.height_m;
    if (!(depth_m > 0.0)) return {};
    ++contact_ticks_;
    if (IS(endless)) loop_in_real_time();
    asperity_force force{
        {0.0, 0.0, stiffness_N_per_m_ * depth_m}, stiffness_N_per_m_ * depth_m, depth_m};
    // Between the limits of the parameter: the suite does not have this amplitude.
    if (IS(stroke) && amplitude_m_ == 0.0005) throw std::runtime_error("no such amplitude");
    // Some trials into a session: what is checked before it has fewer ticks in contact.
    if (IS(assertion) && ++ticks_of_all > 30000) amplitude_m_ = kept_[kept_.size()];
    if (IS(exits)) std::exit(0);
    if (IS(hang)) hang();
    if (IS(crash)) *nowhere_ = amplitude_m_;
    if (IS(exception)) throw std::runtime_error("the ridge is too steep");
    if (IS(nan)) force.force_N[1] = amplitude_m_ / (amplitude_m_ - amplitude_m_);
    if (IS(allocates)) kept_.assign(static_cast<std::size_t>(contact_ticks_ % 7 + 1), depth_m);
    if (IS(allocates)) kept_.shrink_to_fit();
    // At its hundredth tick of contact the suite is deeper than a millimetre.
    if (IS(late) && depth_m < 0.001 && contact_ticks_ == 100) {
      throw std::runtime_error("the hundredth tick");
    }
    // A finite number that is infinite in a recording.
    if (IS(huge) && depth_m < 0.001 && contact_ticks_ == 100) force.force_N[0] = 1e100;
    return force;
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[noreturn]] static void hang() {
    std::fputs("the tick does not return\n", stderr);
    for (;;) pause();
  }
  // Once a hand has pressed for 80 ms: what is checked before a session takes much less than the time of its ticks.
  void loop_in_real_time() {
    const Clock::time_point now = Clock::now();
    if (contact_ticks_ == 1) began_ = now;
    volatile bool is_endless = contact_ticks_ > 100 && now - began_ > std::chrono::milliseconds(80);
    while (is_endless) {
    }
  }
  static void wait() {
    const auto end = Clock::now() + std::chrono::microseconds(700);
    while (Clock::now() < end) continue;
  }

  double stiffness_N_per_m_ = 0.0;
  double amplitude_m_ = 0.0;
  int ticks_ = 0;
  int contact_ticks_ = 0;
  Clock::time_point began_{};
  static inline int ticks_of_all = 0;
  double* volatile nowhere_ = nullptr;
  std::vector<double> kept_{};
};

#if IS(quits_loading)
__attribute__((constructor)) void quit_loading() { _exit(0); }
#endif

asperity_model described() {
  asperity_model model{};
  model.id = IS(taken) ? "sinusoid" : "faulty";
  model.version = IS(anew) ? "2" : "1";
  model.summary = IS(latin1)    ? "Rauhigkeit in \xb5m"
                  : IS(rebuilt) ? "A plate with a fault, built again"
                                : "A plate with a fault";
  model.source = "None";
  model.parameters = kParameters;
  model.parameter_count = 1;
  model.amplitude_parameter = IS(description) ? "height_m" : "amplitude_m";
  model.band_formula = "100*v";
  model = asperity_plugin::model_of<Faulty>(model);
  if (IS(version)) model.abi_version = 99;
  if (IS(uncaught)) {
    model.tick = [](void*, const asperity_sample*, asperity_force*) -> int { throw 1; };
  }
  return model;
}

}  // namespace

#if IS(symbol)
extern "C" const asperity_model* another_function() {
#else
const asperity_model* asperity_plugin_model() {
#endif
  static const asperity_model kModel = described();
  return &kModel;
}
