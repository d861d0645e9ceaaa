#include "device/simulated_models.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

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
  std::vector<DeviceTrait> known{};  ///< and nothing else
  std::string sources{};             ///< of what is known
};

std::vector<DeviceTrait> missing_of(const Model& model) {
  return traits_without(kDeviceTraits, model.known);
}

std::string remarks_on(const Model& model) {
  std::string missing{};
  for (const DeviceTrait trait : missing_of(model)) {
    missing += (missing.empty() ? "" : ", ") + std::string(name_of(trait));
  }
  std::replace(missing.begin(), missing.end(), '_', ' ');
  return model.sources +
         " Properties of the real device that are unknown to this program: " + missing +
         ". The simulated device lacks these properties or takes them from its virtual hand.";
}

// A Falcon's reading waits for one frame each way, at most one period of its rate.
Model falcon() {
  const DeviceCapability capability = falcon_capability();
  return {.name = "falcon",
          .capability = capability,
          .latency_s = 1.0 / capability.maximum_rate_Hz,
          .velocity = falcon::LineSettings{}.velocity,
          .known = {DeviceTrait::workspace, DeviceTrait::peak_force, DeviceTrait::rate,
                    DeviceTrait::latency, DeviceTrait::position_step},
          .sources =
              "Workspace, force and resolution are those that its driver declares; the latency of "
              "1 ms is one frame."};
}

// The SDK's own figure for the fastest exchange stands for its latency. Of a model without figures, force and workspace
// are bounds that its driver keeps.
enum class PublishedFigures { known, none };
Model force_dimension(const DeviceCapability& capability, PublishedFigures figures) {
  Model model{.name = capability.model,
              .capability = capability,
              .latency_s = 1.0 / capability.maximum_rate_Hz,
              .velocity = ForceDimensionDevice::kWindow,
              .known = {DeviceTrait::rate, DeviceTrait::latency}};
  if (figures == PublishedFigures::known) {
    model.known.insert(model.known.end(), {DeviceTrait::workspace, DeviceTrait::peak_force});
  }
  model.sources =
      "Workspace and force are those that its driver declares; the latency of 0.25 ms is one "
      "exchange at its highest rate.";
  return model;
}

std::vector<Model> models() {
  // System types of the SDK, one for each model.
  constexpr std::array kSystemTypes{63, 64, 33, 34, 35, 104, 106};
  constexpr int kLambda7 = 108;  // has those of sigma.7 (force_dimension/dhd_models.h)
  std::vector<Model> all{falcon()};
  for (const int type : kSystemTypes) {
    all.push_back(force_dimension(dhd_model_of(type).value().capability, PublishedFigures::known));
  }
  all.push_back(force_dimension(dhd_model_of(kLambda7).value().capability, PublishedFigures::none));
  return all;
}

// A property of a real arm, or of a hand on it, that replaces the model's own.
struct Property {
  std::string_view name{};
  std::optional<DeviceTrait> trait{};  ///< that it makes known
  void (*set)(SimulatedDeviceSettings&, double) = nullptr;
};

void set_velocity_samples(SimulatedDeviceSettings& settings, double value) {
  settings.sensor.velocity.reset();
  if (value == 0.0) return;
  if (value != std::floor(value) || value < 2.0 || value > VelocityEstimator::kMostSamples) {
    throw std::runtime_error("velocity_samples of the simulated device must be 0 or from 2 to " +
                             std::to_string(VelocityEstimator::kMostSamples));
  }
  settings.sensor.velocity = VelocityWindow{.samples = static_cast<int>(value)};
}

constexpr std::array kProperties{
    Property{"mass_kg", DeviceTrait::moving_mass,
             [](SimulatedDeviceSettings& to, double value) { to.hand.mass_kg = value; }},
    Property{"damping_N_s_per_m", DeviceTrait::damping,
             [](SimulatedDeviceSettings& to, double value) { to.hand.damping_N_s_per_m = value; }},
    Property{"normal_damping_N_s_per_m", std::nullopt,
             [](SimulatedDeviceSettings& to, double value) {
               to.hand.normal_damping_N_s_per_m = value;
             }},
    Property{"stiffness_N_per_m", std::nullopt,
             [](SimulatedDeviceSettings& to, double value) { to.hand.stiffness_N_per_m = value; }},
    Property{"friction_N", DeviceTrait::friction,
             [](SimulatedDeviceSettings& to, double value) { to.friction_N = value; }},
    Property{"latency_s", DeviceTrait::latency,
             [](SimulatedDeviceSettings& to, double value) { to.sensor.latency_s = value; }},
    Property{"position_step_m", DeviceTrait::position_step,
             [](SimulatedDeviceSettings& to, double value) { to.sensor.position_step_m = value; }},
    Property{"position_noise_m", DeviceTrait::position_noise,
             [](SimulatedDeviceSettings& to, double value) { to.sensor.position_noise_m = value; }},
    Property{"velocity_samples", std::nullopt, set_velocity_samples}};

const Property& property_of(std::string_view name) {
  std::string names{};
  for (const Property& property : kProperties) {
    if (property.name == name) return property;
    names += (names.empty() ? "" : ", ") + std::string(property.name);
  }
  throw std::runtime_error("the simulated device has no property \"" + std::string(name) +
                           "\"; it has: " + names);
}

double number_in(std::string_view text, const Property& property) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, value);
  if (read.ec == std::errc() && read.ptr == end && std::isfinite(value)) return value;
  throw std::runtime_error(std::string(property.name) + " of the simulated device is \"" +
                           std::string(text) + "\"; it must be a number");
}

// "KEY=VALUE,KEY=VALUE": replaces properties, and states so in the remarks.
void take_properties(std::string_view list, SimulatedDeviceSettings& settings) {
  DeviceCapability& real = settings.stands_for.value();
  real.remarks += (real.remarks.empty() ? "" : " ") + std::string("Given for this simulation: ") +
                  std::string(list) + ".";
  do {
    const std::string_view one = list.substr(0, list.find(','));
    list.remove_prefix(std::min(one.size() + 1, list.size()));
    const std::size_t equals = std::min(one.find('='), one.size());
    const Property& property = property_of(one.substr(0, equals));
    property.set(settings, number_in(one.substr(std::min(equals + 1, one.size())), property));
    if (property.trait) std::erase(real.not_known, *property.trait);
  } while (!list.empty());
}

SimulatedDeviceSettings as_named_model(std::string_view name, SimulatedDeviceSettings settings) {
  if (name == kIdealModel) {
    VirtualHand hand(HandHabits{}, Random(0));
    settings.stands_for = SimulatedDevice(hand, settings).capability();
    return settings;
  }
  std::string names{};
  for (const Model& model : models()) {
    names += model.name + ", ";
    if (model.name != name) continue;
    settings.stands_for = model.capability;
    settings.stands_for->model = std::string(kInPlaceOf) + model.capability.model;
    settings.stands_for->remarks = remarks_on(model);
    settings.stands_for->not_known = missing_of(model);
    settings.peak_force_N = model.capability.peak_force_N;
    settings.sensor.latency_s = model.latency_s;
    settings.sensor.position_step_m = model.capability.position_resolution_m;
    settings.sensor.velocity = model.velocity;
    return settings;
  }
  throw std::runtime_error("the simulated device has no model \"" + std::string(name) +
                           "\"; it has: " + names + std::string(kIdealModel));
}

}  // namespace

std::vector<std::string> simulated_models() {
  std::vector<std::string> names;
  for (const Model& model : models()) names.push_back(model.name);
  return names;
}

SimulatedDeviceSettings as_model(std::string_view name, SimulatedDeviceSettings settings) {
  const std::size_t comma = name.find(',');
  settings = as_named_model(name.substr(0, comma), std::move(settings));
  if (comma != std::string_view::npos) take_properties(name.substr(comma + 1), settings);
  return settings;
}

std::string_view model_stood_for(std::string_view in_place_of) noexcept {
  return in_place_of.starts_with(kInPlaceOf) ? in_place_of.substr(kInPlaceOf.size())
                                             : std::string_view();
}

std::vector<DeviceTrait> not_known_of(std::string_view in_place_of) {
  const std::string_view label = model_stood_for(in_place_of);
  if (label.empty()) return {};
  for (const Model& model : models()) {
    if (model.capability.model == label) return missing_of(model);
  }
  return {};
}

std::optional<VelocityWindow> velocity_window_stood_for(std::string_view in_place_of) {
  const std::string_view label = model_stood_for(in_place_of);
  if (label.empty()) return {};
  for (const Model& model : models()) {
    if (model.capability.model == label) return model.velocity;
  }
  return {};
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
