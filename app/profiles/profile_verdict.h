// A device's profile in sentences: what is known of the device, and whether it met its limits.

#pragma once

#include <functional>
#include <string>

#include "app/profiles/device_profile.h"
#include "app/words/phrase.h"

namespace asperity {

/// "Simulated model of delta.3; known: workspace, …; unknown: …": the line above the items of such a
/// device. Empty of every other.
Phrase what_is_known(const DeviceProfile& profile);
/// What items are called where they are read: "friction_N" at a terminal, "Friction" in a window.
using ItemNames = std::function<std::string(const std::string& item)>;
/// Whether it met its limits, with and without a number, and which limited items were not measured. A
/// sentence or two. Without `called` items have their own names.
Phrase verdict_on(const DeviceProfile& profile, const ItemNames& called = {});

}  // namespace asperity
