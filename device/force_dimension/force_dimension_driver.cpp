// Surveys the devices by opening each in turn, unless the program uses one of them.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "device/force_dimension/dhd_models.h"
#include "device/force_dimension/force_dimension_device.h"
#include "device/force_dimension/open_unit.h"
#include "device/units_in_use.h"

namespace asperity {

using namespace force_dimension;

namespace {

DriverSurvey survey_of(const DhdFunctions& sdk, const std::stop_token& stop) {
  DriverSurvey survey{.found = sdk.description(), .attached = UnitInUse::of(kDriver)};
  const std::vector<AttachedDevice> ours = survey.attached;
  const int count = std::max(0, sdk.dhdGetDeviceCount());
  // The SDK opens a device that is already open without an error, and closing it would end it for its user. Indices can
  // change when devices are plugged in. So none is opened while one is used.
  const bool one_is_used =
      !ours.empty() || (sdk.dhdGetAvailableCount != nullptr && sdk.dhdGetAvailableCount() < count);
  for (int index = 0; index < count && !stop.stop_requested(); ++index) {
    AttachedDevice device{.model = "Force Dimension", .place = place_of(index)};
    if (std::any_of(ours.begin(), ours.end(),
                    [&device](const AttachedDevice& used) { return used.place == device.place; })) {
      continue;
    }
    if (one_is_used) {
      device.blocker =
          "The model of this device cannot be read while another Force Dimension device is in use: "
          "close that one, then search again.";
      survey.attached.push_back(device);
      continue;
    }
    try {
      const Identity identity = open_index(sdk, index);
      device.serial = identity.serial;
      if (const std::optional<DhdModel> model = dhd_model_of(identity.type)) {
        device.model = model->capability.model;
        device.remark = sdk.has_robotics()
                            ? "After power-on it has to move by itself for some seconds to find "
                              "its zero; confirmation is requested before it moves."
                            : "";
      } else {
        device.blocker = unknown_type(identity.type);
      }
      sdk.dhdClose(identity.id);
    } catch (const std::runtime_error& refusal) {
      device.blocker = refusal.what();
    }
    survey.attached.push_back(device);
  }
  return survey;
}

// Requests confirmation while others may search for devices. The confirmation is for a movement now: after a delay a hand
// may be in the way again.
bool agrees_now(const DriverOptions& options, const std::string& sentence) {
  constexpr std::chrono::seconds kLongestAfterYes(1);
  bool is_agreed = false;
  std::chrono::steady_clock::time_point answered{};
  {
    const LetOthersLook meanwhile(options.alone, options.stop);
    is_agreed = options.may_move(sentence);
    answered = std::chrono::steady_clock::now();
  }
  const auto waited = std::chrono::steady_clock::now() - answered;
  if (is_agreed && !options.stop.stop_requested() && waited > kLongestAfterYes) {
    throw std::runtime_error(
        "The device was not moved: another search for devices delayed the movement by more than a "
        "second "
        "after the confirmation. Open it again, and confirm again.");
  }
  return is_agreed;
}

}  // namespace

Driver force_dimension_driver() {
  return {.id = "force_dimension",
          .name = "Force Dimension",
          .summary =
              "delta, omega, sigma and lambda of Force Dimension, through the manufacturer's SDK.",
          .is_closed_by_another_process = true,
          .velocity = ForceDimensionDevice::kWindow,
          .find =
              [](const DriverOptions& options) {
                try {
                  const DhdFunctions sdk(options.library);
                  return survey_of(sdk, options.stop);
                } catch (const std::runtime_error& refusal) {
                  return DriverSurvey{.blocker = refusal.what()};
                }
              },
          .open = [](const std::string& which,
                     const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
            auto sdk = std::make_shared<const DhdFunctions>(options.library);
            const std::vector<AttachedDevice> attached = survey_of(*sdk, options.stop).attached;
            if (options.stop.stop_requested()) {
              throw OpeningStopped(
                  "no device of Force Dimension was opened: opening was stopped on request; open "
                  "the device again to use it");
            }
            ForceDimensionDevice::MayMove may_move{};
            if (options.may_move) {
              may_move = [&options](const std::string& sentence) {
                return agrees_now(options, sentence);
              };
            }
            const std::string place =
                choose_attached("device of Force Dimension", attached, which).place;
            for (std::size_t index = 0; index < attached.size(); ++index) {
              if (attached[index].place != place) continue;
              return std::make_unique<ForceDimensionDevice>(std::move(sdk), static_cast<int>(index),
                                                            may_move, options.stop, options.tell);
            }
            throw std::logic_error(
                "the chosen device is not attached; plug it in, or choose another device");
          }};
}

}  // namespace asperity
