// Holds the capabilities and traits of each model with their sources, and parses given properties.

#include "device/simulated_models.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "device/falcon/falcon_device.h"
#include "device/force_dimension/dhd_models.h"
#include "device/force_dimension/force_dimension_device.h"
#include "device/openhaptics/openhaptics_device.h"

namespace asperity {
namespace {

constexpr std::string_view kSimulated = "simulated";

// Between a model and the properties that were given to it, in the model of a capability.
constexpr std::string_view kWith = " with ";

// The model of the simulated device that stands for no other.
std::string plain_model() {
  VirtualHand hand(HandHabits{}, Random(0));
  return SimulatedDevice(hand, {}).capability().model;
}

struct Model {
  std::string name{};
  DeviceCapability capability{};
  double latency_s = 0.0;
  std::optional<VelocityWindow> velocity{};
  std::optional<double> friction_N{};      ///< nothing where it is unknown, as the next one
  std::optional<double> moving_mass_kg{};  ///< apparent
  std::vector<DeviceTrait> known{};        ///< and nothing else
  std::string sources{};                   ///< of what is known
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

// The manufacturer's figures for the Touch (formerly Geomagic Touch, Phantom Omni): workspace 160 × 120 × 70 mm (width, height,
// depth), greatest force at the nominal position 3.3 N, continuous 0.88 N, nominal position resolution above 450 dpi (0.055 mm),
// backdrive friction below 1 oz (0.26 N), apparent mass at the tip 45 g [3D Systems]. Our y is its depth and our z its
// height. Assumed: a workspace about the origin, as the driver places it, the same force everywhere in it, and the bounds of
// resolution and friction as their values. A reading and its force are exchanged in one frame of OpenHaptics' scheduler.
Model touch() {
  constexpr double kFrame_Hz = 1000.0;
  DeviceCapability capability{.name = "openhaptics",
                              .model = "Touch",
                              .sensed_degrees_of_freedom = 6,
                              .workspace_minimum_m = {-0.080, -0.035, -0.060},
                              .workspace_maximum_m = {0.080, 0.035, 0.060},
                              .peak_force_N = 3.3,
                              .continuous_force_N = 0.88,
                              .position_resolution_m = 55e-6,
                              .maximum_rate_Hz = kFrame_Hz,
                              .buttons = 2};
  return {.name = "touch",
          .capability = std::move(capability),
          .latency_s = 1.0 / kFrame_Hz,
          .velocity = openhaptics_driver().velocity,
          .friction_N = 0.26,
          .moving_mass_kg = 0.045,
          .known = {DeviceTrait::workspace, DeviceTrait::peak_force, DeviceTrait::continuous_force,
                    DeviceTrait::rate, DeviceTrait::latency, DeviceTrait::position_step,
                    DeviceTrait::friction, DeviceTrait::moving_mass},
          .sources =
              "Workspace, forces, resolution, friction and apparent mass are the manufacturer's "
              "figures; of resolution and friction they are bounds. The latency of 1 ms is one "
              "frame of OpenHaptics' scheduler."};
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
  all.push_back(touch());
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
    throw std::runtime_error("velocity_samples of the simulated device is " + number_text(value) +
                             "; it must be 0, or a whole number from 2 to " +
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

std::string names_of_properties() {
  std::string names{};
  for (const Property& property : kProperties) {
    names += (names.empty() ? "" : ", ") + std::string(property.name);
  }
  return names;
}

std::size_t property_of(std::string_view name) {
  for (std::size_t i = 0; i < kProperties.size(); ++i) {
    if (kProperties[i].name == name) return i;
  }
  throw std::runtime_error("the simulated device has no property \"" + std::string(name) +
                           "\"; choose one of: " + names_of_properties());
}

double number_in(std::string_view text, const Property& property) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, value);
  if (read.ec == std::errc() && read.ptr == end && std::isfinite(value)) return value;
  throw std::runtime_error(std::string(property.name) + " of the simulated device is \"" +
                           std::string(text) + "\"; it must be a number");
}

std::string shortest_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

using GivenProperties = std::array<std::optional<double>, kProperties.size()>;

// "KEY=VALUE,KEY=VALUE"
GivenProperties given_properties(std::string_view list) {
  GivenProperties given{};
  std::string_view last{};
  for (bool has_more = true; has_more;) {
    const std::size_t comma = list.find(',');
    const std::string_view one = list.substr(0, comma);
    has_more = comma != std::string_view::npos;
    if (has_more) list.remove_prefix(comma + 1);
    if (one.empty()) {
      throw std::runtime_error(
          "a comma after " +
          (last.empty() ? std::string("the model") : '"' + std::string(last) + '"') +
          " of the simulated device has no property after it; remove the comma, or add one of: " +
          names_of_properties());
    }
    last = one;
    const std::size_t equals = one.find('=');
    const std::size_t which = property_of(one.substr(0, equals));
    const Property& property = kProperties[which];
    if (given[which]) {
      throw std::runtime_error(std::string(property.name) +
                               " of the simulated device is given twice; give it once");
    }
    given[which] = number_in(
        equals == std::string_view::npos ? std::string_view() : one.substr(equals + 1), property);
  }
  return given;
}

// In the order of the properties and with the shortest digits, so that one device has one text.
std::string properties_text(const GivenProperties& given) {
  std::string text{};
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) continue;
    text += (text.empty() ? "" : ",") + std::string(kProperties[i].name) + '=' +
            shortest_text(*given[i]);
  }
  return text;
}

// Replaces properties, and states so in the model and the remarks.
void take_properties(std::string_view list, SimulatedDeviceSettings& settings) {
  const GivenProperties given = given_properties(list);
  DeviceCapability& real = settings.stands_for.value();
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) continue;
    kProperties[i].set(settings, *given[i]);
    if (kProperties[i].trait) std::erase(real.not_known, *kProperties[i].trait);
  }
  const std::string text = properties_text(given);
  real.model += std::string(kWith) + text;
  real.remarks +=
      (real.remarks.empty() ? "" : " ") + std::string("Given for this simulation: ") + text + ".";
  VirtualHand hand(HandHabits{}, Random(0));
  (void)SimulatedDevice(hand, settings);  // refuses values that are out of range
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
    if (model.friction_N) settings.friction_N = *model.friction_N;
    if (model.moving_mass_kg) settings.hand.mass_kg = *model.moving_mass_kg;
    return settings;
  }
  throw std::runtime_error("the simulated device has no model \"" + std::string(name) +
                           "\"; choose one of: " + names + std::string(kIdealModel));
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
  if (!in_place_of.starts_with(kInPlaceOf)) return {};
  in_place_of.remove_prefix(kInPlaceOf.size());
  return in_place_of.substr(0, in_place_of.find(kWith));
}

std::string_view properties_given_in(const DeviceCapability& device) noexcept {
  const std::string_view model = device.model;
  const std::size_t with = model.find(kWith);
  if (device.name != kSimulated || with == std::string_view::npos) return {};
  return model.substr(with + kWith.size());
}

std::optional<SimulatedDeviceSettings> settings_of_model(std::string_view model) {
  const std::size_t with = model.find(kWith);
  const std::string properties(
      with == std::string_view::npos ? "" : ',' + std::string(model.substr(with + kWith.size())));
  std::string name(kIdealModel);
  if (const std::string_view label = model_stood_for(model); !label.empty()) {
    const std::vector<Model> all = models();
    const auto found = std::find_if(all.begin(), all.end(), [label](const Model& one) {
      return one.capability.model == label;
    });
    if (found == all.end()) return {};
    name = found->name;
  } else if (model.substr(0, with) != plain_model()) {
    return {};
  }
  try {
    return as_model(name + properties, {});
  } catch (const std::exception&) {
    return {};
  }
}

std::vector<DeviceTrait> not_known_of(std::string_view model) {
  const auto settings = settings_of_model(model);
  return settings ? settings->stands_for->not_known : std::vector<DeviceTrait>{};
}

std::optional<SimulatedDeviceSettings> simulated_settings(std::string_view device) {
  if (!device.starts_with(kSimulated)) return std::nullopt;
  const std::string_view rest = device.substr(kSimulated.size());
  if (rest.empty()) return SimulatedDeviceSettings{};
  if (rest.front() != ':') return std::nullopt;
  return as_model(rest.substr(1), {});
}

}  // namespace asperity
