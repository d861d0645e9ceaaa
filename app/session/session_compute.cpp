// Opens the first compute device, with a deadline of 400 µs in real time, and stores its name as JSON.

#include "app/session/session_compute.h"

#include <chrono>
#include <exception>

#include <nlohmann/json.hpp>

#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "protocols/plan/plan.h"
#include "results_schema/error_text.h"

namespace asperity {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kRealTime = 400us;
constexpr std::chrono::nanoseconds kSimulatedTime = 60s;

std::shared_ptr<const Compute> compute_within(std::chrono::nanoseconds deadline) {
  try {
    return first_compute(deadline);
  } catch (const std::exception& error) {
    throw PhrasedError(
        phrase("RunSession",
               "contacts cannot be evaluated on a GPU: %1 (on the command line: --compute cpu; in "
               "the protocol: device.compute)")
            .with(message_of(error)));
  }
}

}  // namespace

std::shared_ptr<const Compute> compute_in_real_time() { return compute_within(kRealTime); }

std::shared_ptr<const Compute> compute_on_simulated_clock() {
  return compute_within(kSimulatedTime);
}

void require_two_bodies(const Protocol& protocol, const ModelRegistry& models) {
  for (const Trial& trial : possible_trials(protocol)) {
    for (const PlannedPresentation& presentation : trial.presentations) {
      const ForceModel* const model = models.find(presentation.stimulus.model);
      if (model != nullptr && model->declaration.needs_bodies) return;
    }
  }
  throw PhrasedError(
      phrase("RunSession",
             "no stimulus of the protocol %1 has a force model with two bodies, and only its "
             "contacts are evaluated on a GPU; leave out --compute or device.compute")
          .with(protocol.name));
}

nlohmann::ordered_json json_of_compute(const ModelRegistry& models) {
  for (const ForceModel& model : models.models()) {
    if (!model.compute) continue;
    const ComputeDeviceName& name = model.compute->device.name();
    return {{"device", name.device}, {"platform", name.platform}, {"driver", name.driver}};
  }
  return nullptr;
}

std::optional<ComputeDeviceName> stored_compute(const nlohmann::json& data) {
  const auto found = data.find("compute");
  if (found == data.end() || !found->is_object()) return std::nullopt;
  return ComputeDeviceName{.device = found->value("device", ""),
                           .platform = found->value("platform", ""),
                           .driver = found->value("driver", "")};
}

bool is_same(const ComputeDeviceName& one, const ComputeDeviceName& other) {
  return one.device == other.device && one.platform == other.platform && one.driver == other.driver;
}

}  // namespace asperity
