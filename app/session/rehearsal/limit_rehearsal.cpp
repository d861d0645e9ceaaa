// Compares the limits of a protocol for its device with a profile.

#include "app/session/rehearsal/limit_rehearsal.h"

#include <optional>
#include <string>

#include "protocols/design/json_pointer.h"

namespace asperity {
namespace {

constexpr const char* kResonanceItem = "resonance_Hz";

std::optional<RehearsalWarning> warning_of_limit(const DeviceQuantity& quantity, double limit,
                                                 const DeviceProfile& profile) {
  const std::string name = quantity.name;
  const std::string asked = in_three_digits(limit);
  const bool at_most = quantity.bound == DeviceItem::Bound::at_most;
  if (const std::optional<double> value = profile.value(name)) {
    if (keeps(*value, quantity.bound, limit)) return {};
    const Phrase text = at_most ? phrase("Rehearsal",
                                         "The protocol requires a device whose %1 is at most %2; "
                                         "the measured value is %3. Choose another device, or "
                                         "relax the requirement in the protocol.")
                                : phrase("Rehearsal",
                                         "The protocol requires a device whose %1 is at least "
                                         "%2; the measured value is %3. Choose another device, or "
                                         "relax the requirement in the protocol.");
    return RehearsalWarning{.id = "limit_" + name,
                            .pointer = pointer_to("/device/limits", name),
                            .asked = limit,
                            .device = *value,
                            .text = text.with(name, asked, in_three_digits(*value))};
  }
  // Most devices have no resonance, which meets every limit; unless it is marked as unknown.
  if (name == kResonanceItem && !profile.is_unknown(name)) return {};
  const Phrase text =
      at_most
          ? phrase("Rehearsal",
                   "The protocol requires a device whose %1 is at most %2, but this quantity was "
                   "not measured. Measure the device again, or remove the limit from the protocol.")
          : phrase(
                "Rehearsal",
                "The protocol requires a device whose %1 is at least %2, but this quantity was not "
                "measured. Measure the device again, or remove the limit from the protocol.");
  return RehearsalWarning{.id = "unmeasured_" + name,
                          .pointer = pointer_to("/device/limits", name),
                          .asked = limit,
                          .text = text.with(name, asked)};
}

}  // namespace

std::vector<RehearsalWarning> limit_warnings(const Protocol& protocol,
                                             const DeviceProfile& profile) {
  std::vector<RehearsalWarning> warnings{};
  for (const auto& [name, limit] : protocol.device_limits) {
    const DeviceQuantity* const quantity = device_quantity(name);
    if (quantity == nullptr || (quantity->is_timing && profile.is_simulated)) continue;
    if (auto warning = warning_of_limit(*quantity, limit, profile)) {
      warnings.push_back(std::move(*warning));
    }
  }
  return warnings;
}

}  // namespace asperity
