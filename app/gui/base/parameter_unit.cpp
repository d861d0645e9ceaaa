// Implements the choice of units for parameters.

#include "app/gui/base/parameter_unit.h"

#include <numbers>

namespace asperity {

DisplayUnit display_unit_of(const Parameter& parameter) {
  constexpr double kSmallLength_m = 0.01;  // what reaches no further is shown in micrometres
  constexpr double kDegrees = 180.0;
  if (parameter.unit == "m" && parameter.maximum < kSmallLength_m) {
    return {.unit = "µm", .power = -6};
  }
  if (parameter.unit == "m") return {.unit = "mm", .power = -3};
  if (parameter.unit == "m/s") return {.unit = "mm/s", .power = -3};
  if (parameter.unit == "rad") return {.unit = "°", .factor = std::numbers::pi / kDegrees};
  return {};
}

}  // namespace asperity
