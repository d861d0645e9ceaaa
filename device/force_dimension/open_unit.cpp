// Calls the functions of the SDK by the identity of a device, and composes its errors.

#include "device/force_dimension/open_unit.h"

#include <stdexcept>

namespace asperity::force_dimension {

std::string place_of(int index) { return "dhd " + std::to_string(index); }

std::string last_error_of(const DhdFunctions& sdk) {
  const char* words = sdk.dhdErrorGetLastStr();
  return words == nullptr ? "the SDK states no reason" : words;
}

void close_device(const DhdFunctions& sdk, const Identity& identity) {
  identity.is_robotic ? sdk.drdClose(identity.id) : sdk.dhdClose(identity.id);
}

Identity identity_of(const DhdFunctions& sdk, int index, int id) {
  Identity identity{.index = static_cast<char>(index),
                    .id = static_cast<char>(id),
                    .type = sdk.dhdGetSystemType(static_cast<char>(id))};
  unsigned short serial = 0;
  if (sdk.dhdGetSerialNumber(&serial, identity.id) >= 0) identity.serial = std::to_string(serial);
  return identity;
}

Identity open_index(const DhdFunctions& sdk, int index) {
  const int id = sdk.dhdOpenID(static_cast<char>(index));
  if (id < 0) {
    throw std::runtime_error("The Force Dimension device at " + place_of(index) +
                             " cannot be opened: " + last_error_of(sdk) +
                             ". Check that no other program uses it and that this user may open it "
                             "(udev rule for USB vendor 1451).");
  }
  return identity_of(sdk, index, id);
}

std::string unknown_type(int type) {
  return "This device of Force Dimension is of the system type " + std::to_string(type) +
         ", which is unknown to this program: its force limits are unknown, too. Use a device of a "
         "known type.";
}

bool knows_its_zero(const DhdFunctions& sdk, const Identity& identity) {
  int status[DhdFunctions::kStatusSize] = {};
  return sdk.dhdGetStatus(status, identity.id) >= 0 && status[DhdFunctions::kStatusReset] != 0;
}

bool set_zero_force(const DhdFunctions& sdk, char id) noexcept {
  return sdk.dhdSetForceAndTorqueAndGripperForce(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id) >= 0;
}

}  // namespace asperity::force_dimension
