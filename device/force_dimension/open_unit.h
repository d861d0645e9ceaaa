// A device of Force Dimension while the SDK has it open: its identity, and the calls that need no more than that.

#pragma once

#include <string>

#include "device/force_dimension/dhd_functions.h"

namespace asperity::force_dimension {

/// The name under which UnitInUse lists the units.
inline constexpr const char* kDriver = "force_dimension";

/// A unit that is open.
struct Identity {
  char index = 0;  ///< among the attached units
  char id = 0;     ///< by which the SDK knows it while it is open
  int type = -1;
  std::string serial{};
  bool is_robotic = false;  ///< also opened by libdrd
};

Identity identity_of(const DhdFunctions& sdk, int index, int id);
/// Errors: std::runtime_error with the reason of the SDK.
Identity open_index(const DhdFunctions& sdk, int index);
void close_device(const DhdFunctions& sdk, const Identity& identity);

/// Of the last call in this thread.
std::string last_error_of(const DhdFunctions& sdk);
/// The place of a unit in lists: "dhd 0".
std::string place_of(int index);
/// The sentence that refuses a unit of this type.
std::string unknown_type(int type);
/// Whether its controller knows the zero of its positions, which its lamp also shows.
bool knows_its_zero(const DhdFunctions& sdk, const Identity& identity);
/// Requests a force of 0. A unit that was left at another force would exert that as soon as its force is switched on.
bool set_zero_force(const DhdFunctions& sdk, char id) noexcept;

}  // namespace asperity::force_dimension
