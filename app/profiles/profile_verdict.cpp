// Lists known and unknown traits, limits that were not met, and items that were not measured.

#include "app/profiles/profile_verdict.h"

#include <algorithm>

#include "app/words/device_remarks.h"

namespace asperity {

Phrase what_is_known(const DeviceProfile& profile) {
  if (profile.stands_for().empty()) return {};
  return phrase("DeviceTest", "Simulated model of %1; known: %2; unknown: %3.")
      .with(profile.stands_for(), listed_traits(profile.known()), listed_traits(profile.not_known));
}

Phrase verdict_on(const DeviceProfile& profile, const ItemNames& called) {
  const auto names = [&](const auto& is_meant) {
    std::string all{};
    for (const DeviceItem& item : profile.items) {
      if (!is_meant(item)) continue;
      all += (all.empty() ? "" : ", ") + (called ? called(item.name) : item.name);
    }
    return all;
  };
  const std::string failed =
      names([](const DeviceItem& item) { return item.status == DeviceItem::Status::fail; });
  const std::string open = names([](const DeviceItem& item) { return item.is_open(); });
  const bool kept_some =
      std::any_of(profile.items.begin(), profile.items.end(), [](const DeviceItem& item) {
        return item.status == DeviceItem::Status::pass && !item.is_only_told();
      });
  Phrase kept{};
  if (!failed.empty()) {
    kept = phrase("DeviceTest",
                  "The device did not meet every limit: %1. Repair it and measure it again, or "
                  "choose another device.")
               .with(failed);
  } else if (kept_some) {
    kept = open.empty() ? phrase("DeviceTest", "The device met every limit.")
                        : phrase("DeviceTest", "The device met every limit that was measured.");
  } else if (open.empty()) {
    kept = phrase("DeviceTest", "No limit applied to the device.");
  }
  if (open.empty()) return kept;
  const Phrase unseen =
      phrase("DeviceTest", "Not measured, although a limit applies: %1. Measure the device again.")
          .with(open);
  return kept.empty() ? unseen : Phrase("%1 %2").with(kept, unseen);
}

}  // namespace asperity
