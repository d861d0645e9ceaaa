#include "app/session/session_compute.h"

#include <chrono>
#include <exception>

#include <nlohmann/json.hpp>

#include "app/words/phrase.h"

namespace asperity {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kRealTime = 400us;
constexpr std::chrono::nanoseconds kSimulatedTime = 60s;

}  // namespace

std::shared_ptr<const Compute> compute_of_session(bool in_real_time) {
  try {
    return first_compute(in_real_time ? kRealTime : kSimulatedTime);
  } catch (const std::exception& error) {
    throw PhrasedError(
        phrase("RunSession",
               "contacts cannot be evaluated on a GPU: %1 (on the command line: --compute cpu; in "
               "the protocol: device.compute)")
            .with(std::string(error.what())));
  }
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
