// Which of Force Dimension's devices is which.

#include "device/force_dimension/dhd_models.h"

#include <string>

namespace asperity {
namespace {

enum class Turns { no, sensed, actuated };
enum class Gripper { no, yes };

struct Figures {
  const char* model = "";
  double force_N = 0.0;
  double radius_m = 0.0;
};

// With orders that reach the device when they are sent, 4 kHz is what the SDK's pages call the limit.
constexpr double kFastestOrders_Hz = 4000.0;

DhdModel model_of(const Figures& figures, Turns turns, Gripper gripper,
                  const std::string& more = {}) {
  DhdModel model;
  DeviceCapability& capability = model.capability;
  capability.name = "force_dimension";
  capability.model = figures.model;
  capability.sensed_degrees_of_freedom = turns == Turns::no ? 3 : 6;
  capability.actuated_degrees_of_freedom = turns == Turns::actuated ? 6 : 3;
  capability.workspace_minimum_m = glm::dvec3(-figures.radius_m);
  capability.workspace_maximum_m = glm::dvec3(figures.radius_m);
  capability.peak_force_N = figures.force_N;
  capability.maximum_rate_Hz = kFastestOrders_Hz;
  capability.buttons = gripper == Gripper::yes ? 2 : 1;
  capability.remarks =
      "Force and workspace are CHAI3D's values for this model, not measured; resolution and "
      "continuous force are unknown. The manufacturer's software adds the force that supports the "
      "weight of the handle." +
      more;
  model.has_wrist = turns != Turns::no;
  model.has_gripper = gripper == Gripper::yes;
  return model;
}

}  // namespace

std::optional<DhdModel> dhd_model_of(int system_type) {
  switch (system_type) {
    case 63:
      return model_of({"delta.3", 20.0, 0.15}, Turns::no, Gripper::no);
    case 64:
      return model_of({"delta.6", 20.0, 0.15}, Turns::actuated, Gripper::no);
    case 33:
      return model_of({"omega.3", 12.0, 0.075}, Turns::no, Gripper::no);
    case 34:
    case 36:
      return model_of({"omega.6", 12.0, 0.075}, Turns::sensed, Gripper::no);
    case 35:
    case 37:
      return model_of({"omega.7", 12.0, 0.075}, Turns::sensed, Gripper::yes);
    case 104:
    case 105:
      return model_of({"sigma.7", 12.0, 0.075}, Turns::actuated, Gripper::yes);
    case 106:
    case 107:
      return model_of({"sigma.6+", 12.0, 0.09}, Turns::actuated, Gripper::no);
    case 108:
    case 109:
      return model_of({"lambda.7", 12.0, 0.075}, Turns::actuated, Gripper::yes,
                      " No values for lambda.7 were available: the limits of sigma.7 are used.");
    case 60:
      return model_of({"Falcon", 8.0, 0.04}, Turns::no, Gripper::no);
    default:
      return std::nullopt;
  }
}

}  // namespace asperity
