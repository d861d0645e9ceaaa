// Calibrates a device of Force Dimension that has lost its zero, by a movement that the user has confirmed.

#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "device/force_dimension/open_unit.h"

namespace asperity::force_dimension {

/// Does nothing if the device knows its zero. Otherwise it moves by itself, after `may_move` has confirmed it; a stop ends
/// the movement, and `tell` is called if it does not end within a second.
///
/// Errors: OpeningStopped; std::runtime_error if the movement is impossible, not confirmed or fails, or the regulation
/// cannot be ended.
void find_zero(const DhdFunctions& sdk, Identity& identity, const std::string& model,
               const std::function<bool(const std::string&)>& may_move, const std::stop_token& stop,
               const std::function<void(const std::string&)>& tell);

}  // namespace asperity::force_dimension
