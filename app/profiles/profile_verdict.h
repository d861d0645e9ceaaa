// Summarises a device's profile in sentences: the known traits of the device, and whether it met
// its limits.

#pragma once

#include <functional>
#include <string>

#include "analysis/words/phrase.h"
#include "app/profiles/device_profile.h"

namespace asperity {

/// "Simulated model of delta.3; known: workspace, …; unknown: …": the line above the items of such
/// a device. Empty for every other device.
Phrase what_is_known(const DeviceProfile& profile);
/// Display names of items: "friction_N" at a terminal, "Friction" in a window.
using ItemNames = std::function<std::string(const std::string& item)>;
/// Whether the device met its limits, with and without a number, and which items with a limit were
/// not measured. One or two sentences. Without `called` items keep their names.
Phrase verdict_on(const DeviceProfile& profile, const ItemNames& called = {});

}  // namespace asperity
