// Estimates the size of a session from rate and duration, and compares it with the free space.

#include "app/tasks/checks/disk_check.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

#include "analysis/numbers/number_text.h"
#include "app/session/rig/recording_columns.h"
#include "protocols/plan/course.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

constexpr double kStoreBytes = 20e6;     // rows of a session, and the working space of SQLite
constexpr double kWantedSessions = 2.0;  // less room than for this many is reported

std::string bytes_text(double bytes) {
  if (bytes >= 1e9) return fixed(bytes * 1e-9, 1) + " GB";
  return fixed(bytes * 1e-6, 0) + " MB";
}

}  // namespace

SessionCheck disk_check(const CheckInputs& inputs, const Protocol& protocol) {
  std::error_code error{};
  const std::filesystem::space_info space = std::filesystem::space(inputs.study, error);
  if (error) {
    return {
        .state = State::look,
        .text = phrase("SessionChecks", "The free space cannot be determined: %1.")
                    .with(error.message()),
        .remedy = phrase("SessionChecks", "Make sure that the disk has room for the recordings.")};
  }
  return disk_check({.wanted_bytes = recording_bytes(protocol) + kStoreBytes,
                     .free_bytes = static_cast<double>(space.available)});
}

double recording_bytes(const Protocol& protocol) {
  if (!protocol.record) return 0.0;
  // An attempt is recorded from its first pause to its response. Together that is at most the whole session.
  constexpr double kBytesPerRecord = sizeof(std::int64_t) + kRecordingColumns * sizeof(float);
  const PlanCost cost = cost_of(protocol, example_plan(protocol, {1, 0}));
  return cost.total_s * protocol.rate_Hz * kBytesPerRecord;
}

SessionCheck disk_check(const DiskSpace& space) {
  SessionCheck check{};
  check.text = phrase("SessionChecks", "%1 free; this session requires at most %2.")
                   .with(bytes_text(space.free_bytes), bytes_text(space.wanted_bytes));
  if (space.free_bytes < space.wanted_bytes) {
    check.state = State::stop;
    check.remedy = phrase("SessionChecks", "Free some space on the disk of the study.");
  } else if (space.free_bytes < kWantedSessions * space.wanted_bytes) {
    check.state = State::look;
    check.remedy = phrase("SessionChecks",
                          "The space is sufficient for this session, but hardly for another one. "
                          "Free some space soon.");
  }
  return check;
}

}  // namespace asperity
