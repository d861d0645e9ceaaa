#include "device/simulated_models.h"

#include <array>
#include <optional>
#include <stdexcept>

#include "device/falcon/falcon_device.h"
#include "device/force_dimension/dhd_models.h"
#include "device/force_dimension/force_dimension_device.h"

namespace asperity {
namespace {

struct Model {
  std::string name{};
  DeviceCapability capability{};
  double latency_s = 0.0;
  std::optional<VelocityWindow> velocity{};
  std::string remarks{};
};

// A Falcon's reading waits for one frame each way, at most one period of its rate.
Model falcon() {
  const DeviceCapability capability = falcon_capability();
  return {.name = "falcon",
          .capability = capability,
          .latency_s = 1.0 / capability.maximum_rate_Hz,
          .velocity = falcon::LineSettings{}.velocity,
          .remarks =
              "Workspace, force and resolution are those that its driver declares, the latency "
              "of 1 ms is one frame. Friction, noise and moving mass of a Falcon are not known "
              "to this program: there are none."};
}

// The SDK's own figure for the fastest exchange stands for its latency.
Model force_dimension(const DeviceCapability& capability) {
  return {.name = capability.model,
          .capability = capability,
          .latency_s = 1.0 / capability.maximum_rate_Hz,
          .velocity = ForceDimensionDevice::kWindow,
          .remarks =
              "Workspace and force are those that its driver declares, the latency of 0.25 ms "
              "is one exchange at its highest rate. Resolution, friction, noise and moving "
              "mass are not known to this program: there are none."};
}

std::vector<Model> models() {
  // System types of the SDK, one for each model.
  constexpr std::array kSystemTypes{63, 64, 33, 34, 35, 104, 106, 108};
  std::vector<Model> all{falcon()};
  for (const int type : kSystemTypes) {
    all.push_back(force_dimension(dhd_model_of(type).value().capability));
  }
  return all;
}

}  // namespace

std::vector<std::string> simulated_models() {
  std::vector<std::string> names;
  for (const Model& model : models()) names.push_back(model.name);
  return names;
}

SimulatedDeviceSettings as_model(std::string_view name, SimulatedDeviceSettings settings) {
  std::string names;
  for (const Model& model : models()) {
    names += (names.empty() ? "" : ", ") + model.name;
    if (model.name != name) continue;
    settings.stands_for = model.capability;
    settings.stands_for->model = std::string(kInPlaceOf) + model.capability.model;
    settings.stands_for->remarks = model.remarks;
    settings.peak_force_N = model.capability.peak_force_N;
    settings.sensor.latency_s = model.latency_s;
    settings.sensor.position_step_m = model.capability.position_resolution_m;
    settings.sensor.velocity = model.velocity;
    return settings;
  }
  throw std::runtime_error("the simulated device cannot stand for \"" + std::string(name) +
                           "\"; it can for: " + names);
}

std::optional<SimulatedDeviceSettings> simulated_settings(std::string_view device) {
  constexpr std::string_view kName = "simulated";
  if (!device.starts_with(kName)) return std::nullopt;
  const std::string_view rest = device.substr(kName.size());
  if (rest.empty()) return SimulatedDeviceSettings{};
  if (rest.front() != ':') return std::nullopt;
  return as_model(rest.substr(1), {});
}

}  // namespace asperity
