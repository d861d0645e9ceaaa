// Runs the loop on the device for a moment, and compares rate and delays with the protocol.

#include "app/tasks/checks/servo_loop_checks.h"

#include <exception>
#include <string>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/device_choice.h"
#include "app/words/reason.h"
#include "device/pointer_device.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

constexpr double kSlowestRate = 0.9;  // as a fraction of the rate that the protocol requires

std::string time_text(double duration_s) {
  if (duration_s >= 1e-3) return fixed(duration_s * 1e3, 2) + " ms";
  return fixed(duration_s * 1e6, 0) + " µs";
}

TriedDevice try_loop(const CheckInputs& inputs, const Protocol& protocol,
                     const DriverRegistry& drivers) {
  LatestValue<PointerSample> no_pointer{};
  return inputs.trial(inputs.device, protocol, drivers, {.pointer = &no_pointer}, {});
}

}  // namespace

bool can_be_tried(const CheckInputs& inputs) {
  if (!inputs.device_blocker.empty()) return false;
  if (inputs.pacing == RunPacing::stepped) return true;  // without a separate loop
  if (inputs.tried != nullptr) return inputs.tried->failure.empty();
  try {
    return kind_of_device(inputs.device) != DeviceKind::attached;
  } catch (const std::exception&) {
    return false;  // no such device; `device_check` reports this
  }
}

LoopChecks loop_checks(const CheckInputs& inputs, const Protocol& protocol,
                       const DriverRegistry& drivers) {
  if (inputs.pacing == RunPacing::stepped) {
    return {
        fine_check(phrase("SessionChecks", "Not needed: no handle is held in a fast simulation.")),
        fine_check(phrase("SessionChecks", "Not needed: a fast simulation has its own clock."))};
  }
  const TriedDevice trial =
      inputs.tried != nullptr ? *inputs.tried : try_loop(inputs, protocol, drivers);
  if (!trial.failure.empty()) throw PhrasedError(trial.failure);
  const ServoQualityRow& quality = trial.quality;
  SessionCheck zero{};
  if (trial.fault != Fault::none) {
    zero.state = State::stop;
    zero.text =
        phrase("SessionChecks", "The device reported a fault: %1.").with(phrase_of(trial.fault));
    zero.remedy = phrase("SessionChecks", "Fix the problem with the device, then check again.");
  } else if (trial.strongest_N > 0.0) {
    zero.state = State::stop;
    zero.text =
        phrase("SessionChecks", "A force of %1 N was sent although no surface was presented.")
            .with(fixed(trial.strongest_N, 3));
    zero.remedy = phrase("SessionChecks",
                         "Release the handle, switch the device off and on, then check again.");
  } else {
    zero.text = phrase("SessionChecks", "Exactly 0 N was sent in %1 ticks.")
                    .with(std::to_string(quality.ticks));
  }
  SessionCheck rate{};
  const double measured_Hz = quality.period_mean_s > 0.0 ? 1.0 / quality.period_mean_s : 0.0;
  rate.text =
      phrase("SessionChecks", "%1 of %2 Hz; period p99 %3, lateness p99 %4, missed deadlines: %5.")
          .with(fixed(measured_Hz, 0), fixed(protocol.rate_Hz, 0), time_text(quality.period_p99_s),
                time_text(quality.lateness_p99_s), std::to_string(quality.missed_deadlines));
  if (measured_Hz < kSlowestRate * protocol.rate_Hz) {
    rate.state = State::stop;
    rate.remedy =
        phrase("SessionChecks",
               "This computer is too slow or too busy: close other programs, then check again.");
  } else if (quality.missed_deadlines > 0 || quality.lateness_p99_s > 0.5 / protocol.rate_Hz) {
    rate.state = State::look;
    rate.remedy = phrase("SessionChecks",
                         "Close other programs. An attempt does not count if the number of missed "
                         "deadlines exceeds %1.")
                      .with(std::to_string(protocol.maximum_missed_deadlines));
  }
  return {zero, rate};
}

}  // namespace asperity
