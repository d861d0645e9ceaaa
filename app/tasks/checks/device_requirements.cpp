// Compares the force limit and the rate.

#include "app/tasks/checks/device_requirements.h"

#include "app/profiles/device_kind.h"
#include "results_schema/tables/table.h"

namespace asperity {

std::vector<Phrase> complaints_about_device(const Protocol& protocol,
                                            const DeviceCapability& device) {
  std::vector<Phrase> complaints{};
  // A device without motors gives no force, regardless of the protocol: the user has chosen it
  // knowingly.
  const bool has_motors = device.actuated_degrees_of_freedom > 0;
  if (has_motors && protocol.force_limit_N > device.peak_force_N) {
    complaints.push_back(phrase("ProtocolFiles",
                                "the protocol's force_limit_N of %1 N exceeds the peak force of "
                                "the device \"%2\", %3 N")
                             .with(text_of_number(protocol.force_limit_N), called(device),
                                   text_of_number(device.peak_force_N)));
  }
  if (protocol.rate_Hz > device.maximum_rate_Hz) {
    complaints.push_back(
        phrase(
            "ProtocolFiles",
            "the protocol's rate_Hz of %1 Hz exceeds the highest rate of the device \"%2\", %3 Hz")
            .with(text_of_number(protocol.rate_Hz), called(device),
                  text_of_number(device.maximum_rate_Hz)));
  }
  return complaints;
}

}  // namespace asperity
