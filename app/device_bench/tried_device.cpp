// A device that was opened for a moment, without force, before anybody's hand is on it.

#include "app/device_bench/tried_device.h"

#include <algorithm>
#include <memory>

#include <glm/geometric.hpp>

#include "app/session/attempt_measures.h"
#include "app/session/rig/recorder.h"
#include "app/session/rig/rig.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

namespace {

constexpr double kTrial_s = 0.3;    // of the servo loop
constexpr double kWarmUp_s = 0.05;  // a thread's first wake-ups are its latest ones

void run_loop(RealTimeRig& rig, TriedDevice& tried) {
  tried.capability = rig.capability();
  Recorder recorder{};
  rig.pass(kWarmUp_s, recorder);
  recorder.begin(nullptr, tried.rate_Hz, rig.records());
  rig.pass(kTrial_s, recorder);
  tried.fault = rig.loop().status().fault;
  const Recorder::Attempt attempt = recorder.finish(rig.records());
  tried.quality = servo_quality_of(attempt.records, tried.rate_Hz, attempt.lost_records);
  for (const TickRecord& record : attempt.records) {
    tried.strongest_N = std::max(tried.strongest_N, glm::length(record.sent.force_N));
  }
}

}  // namespace

TriedDevice try_device(const std::string& device, const Protocol& protocol,
                       const DriverRegistry& drivers, const DriverOptions& options,
                       const std::string& agreed) {
  TriedDevice tried{.device = device, .rate_Hz = protocol.rate_Hz};
  std::string unanswered{};
  try {
    NamedDevice named{.name = device, .options = options};
    named.options.may_move = [&](const std::string& sentence) {
      const bool is_agreed = sentence == agreed;
      if (!is_agreed) unanswered = sentence;
      return is_agreed && !options.stop.stop_requested();
    };
    const auto rig = open_rig(named, drivers, rig_settings_for(protocol, {}, device), Random(0), 0);
    run_loop(*rig, tried);
  } catch (const std::exception& error) {
    tried = {.device = device,
             .rate_Hz = protocol.rate_Hz,
             .failure = phrase_of(error).as_sentence(),
             .wants_to_move = unanswered,
             .was_stopped = dynamic_cast<const OpeningStopped*>(&error) != nullptr};
  }
  return tried;
}

}  // namespace asperity
