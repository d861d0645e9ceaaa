// Real devices that the simulated one can stand for.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "device/simulated_device.h"

namespace asperity {

/// How the model of a simulated device begins that stands for a real one: "in place of Novint Falcon".
inline constexpr std::string_view kInPlaceOf = "in place of ";

/// The model that stands for no real device: `simulated:ideal` is the plain `simulated`, for properties to be given.
inline constexpr std::string_view kIdealModel = "ideal";

/// What `simulated:MODEL` may name: "falcon", "touch", and Force Dimension's models as its driver calls them,
/// "delta.3", "omega.3".
std::vector<std::string> simulated_models();

/// `settings` with workspace, force, rate, resolution, latency and velocity estimate of a real device:
/// the figures of its driver, and for a Touch those of its manufacturer, with friction and apparent mass. None of them was measured
/// here. What is not known of it, which the capability lists (DeviceCapability::not_known), stays as it is in `settings`, by
/// default ideal.
/// The probe has three degrees of freedom whatever the model has.
///
/// `model` may give properties of a real arm, measured or assumed, that replace those of the model and of the virtual
/// hand: "falcon,mass_kg=0.2,damping_N_s_per_m=1,friction_N=0.3". They are mass_kg, damping_N_s_per_m (along the
/// surface), normal_damping_N_s_per_m (across it) and stiffness_N_per_m of the hand's hold, which include the arm's;
/// friction_N; latency_s, position_step_m, position_noise_m; and velocity_samples, the readings in the driver's estimate
/// (VelocityWindow), 0 for the exact velocity. The capability's model and remarks list them, so that a session and a
/// profile store them and devices with different properties are different devices; they no longer count as unknown. The
/// model "ideal" has no properties of a real device.
///
/// Errors: std::runtime_error naming the models or properties, for one that does not exist, is given twice, is missing
/// after a comma or is not a number; std::invalid_argument for a value that is out of range.
SimulatedDeviceSettings as_model(std::string_view model, SimulatedDeviceSettings settings);

/// "delta.3" of "in place of delta.3" and of "in place of delta.3 with mass_kg=0.2"; empty for a model that stands for no
/// other. A part of its argument.
std::string_view model_stood_for(std::string_view in_place_of) noexcept;

/// "mass_kg=0.2,friction_N=0.3", the properties that were given to a simulated device; empty without any and for other
/// devices. A part of the argument.
std::string_view properties_given_in(const DeviceCapability& device) noexcept;
std::string_view properties_given_in(DeviceCapability&&) = delete;

/// The settings of a simulated device by the model in its capability, "in place of delta.3 with mass_kg=0.2"; nothing for
/// the model of another device.
std::optional<SimulatedDeviceSettings> settings_of_model(std::string_view model);

/// The traits that are unknown of the device that a simulated one of this model stands for; none for the model of another
/// device.
std::vector<DeviceTrait> not_known_of(std::string_view model);

/// The settings for what `--device` names, "simulated", "simulated:MODEL" or "simulated:MODEL,PROPERTY=VALUE,…"; nothing
/// for other devices.
/// Errors: as `as_model`.
std::optional<SimulatedDeviceSettings> simulated_settings(std::string_view device);

}  // namespace asperity
