// The items of a device's profile in words and in the units that people read.

#pragma once

#include <string>
#include <vector>

#include <QtCore/QString>

#include "app/gui/look/controls.h"
#include "app/profiles/device_profile.h"

namespace asperity {

/// "Friction"; the item's own name where these windows do not know it.
QString title_of_item(const std::string& name);
/// "0.182 N", "31 µs"
QString value_in_words(const std::string& name, double value);
/// "≤ 1 ms"; empty without a limit.
QString limit_in_words(const DeviceItem& item);

/// How an item came out, as a shape and a word.
struct ItemResult {
  State state = State::unknown;
  QString words{};
};
ItemResult result_of(const DeviceItem& item);

/// The items of a profile by what they are about, in its order.
struct ItemGroup {
  QString name{};
  std::vector<const DeviceItem*> items{};
};
std::vector<ItemGroup> groups_of(const DeviceProfile& profile);

/// "2 failed, 15 passed, 1 not measured"; to be looked at where a limit was not measured.
ItemResult verdict_of(const DeviceProfile& profile);
/// "2 failed", "pass"
ItemResult short_verdict_of(const DeviceProfile& profile);
/// "less than a day", "12 days"
QString text_of_age(double days);
/// "2026-03-02 09:00", in the time of this place
QString date_in_words(const std::string& utc);

}  // namespace asperity
