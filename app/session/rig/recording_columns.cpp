// Holds the list of columns with units, in the order of the floats.

#include "app/session/rig/recording_columns.h"

#include <cmath>

#include "results_schema/study.h"

namespace asperity {

const std::vector<RecordingColumn>& recording_columns() {
  static const std::vector<RecordingColumn> kColumns{
      {"x_m", "m", "position of the probe's tip, device frame"},
      {"y_m", "m", "position of the probe's tip, device frame"},
      {"z_m", "m", "position of the probe's tip, device frame, up"},
      {"qw", "1", "orientation of the probe, unit quaternion"},
      {"qx", "1", "orientation of the probe, unit quaternion"},
      {"qy", "1", "orientation of the probe, unit quaternion"},
      {"qz", "1", "orientation of the probe, unit quaternion"},
      {"vx_m_per_s", "m/s", "velocity of the probe's tip"},
      {"vy_m_per_s", "m/s", "velocity of the probe's tip"},
      {"vz_m_per_s", "m/s", "velocity of the probe's tip"},
      {"wx_rad_per_s", "rad/s", "angular velocity of the probe"},
      {"wy_rad_per_s", "rad/s", "angular velocity of the probe"},
      {"wz_rad_per_s", "rad/s", "angular velocity of the probe"},
      {"buttons", "1", "pressed buttons as a bit mask"},
      {"fx_N", "N", "force computed by the renderer"},
      {"fy_N", "N", "force computed by the renderer"},
      {"fz_N", "N", "force computed by the renderer"},
      {"tx_N_m", "N m", "torque computed by the renderer, about the tip"},
      {"ty_N_m", "N m", "torque computed by the renderer, about the tip"},
      {"tz_N_m", "N m", "torque computed by the renderer, about the tip"},
      {"sent_fx_N", "N", "force sent to the device, after ramp and limits"},
      {"sent_fy_N", "N", "force sent to the device, after ramp and limits"},
      {"sent_fz_N", "N", "force sent to the device, after ramp and limits"},
      {"sent_tx_N_m", "N m", "torque sent to the device"},
      {"sent_ty_N_m", "N m", "torque sent to the device"},
      {"sent_tz_N_m", "N m", "torque sent to the device"},
      {"penetration_m", "m", "depth of the probe in the surface, texture included"},
      {"gain", "1", "ramp of the presentation, 0 to 1"},
      {"presentation", "1", "position of the surface in its trial; 0 in free space"},
      {"flags", "1", "bits of the tick: limits, misses, faults (docs/formats/recording.md)"},
      {"lateness_s", "s", "start of the tick after its deadline"},
      {"execution_s", "s", "duration of the tick; 0 when simulated"},
  };
  return kColumns;
}

std::array<float, kRecordingColumns> columns_of(const TickRecord& record) noexcept {
  const auto f = [](double value) { return static_cast<float>(value); };
  const ProbeState& probe = record.probe;
  return {f(probe.position_m.x),
          f(probe.position_m.y),
          f(probe.position_m.z),
          f(probe.orientation.w),
          f(probe.orientation.x),
          f(probe.orientation.y),
          f(probe.orientation.z),
          f(probe.velocity_m_per_s.x),
          f(probe.velocity_m_per_s.y),
          f(probe.velocity_m_per_s.z),
          f(probe.angular_velocity_rad_per_s.x),
          f(probe.angular_velocity_rad_per_s.y),
          f(probe.angular_velocity_rad_per_s.z),
          static_cast<float>(probe.buttons),
          f(record.rendered.force_N.x),
          f(record.rendered.force_N.y),
          f(record.rendered.force_N.z),
          f(record.rendered.torque_N_m.x),
          f(record.rendered.torque_N_m.y),
          f(record.rendered.torque_N_m.z),
          f(record.sent.force_N.x),
          f(record.sent.force_N.y),
          f(record.sent.force_N.z),
          f(record.sent.torque_N_m.x),
          f(record.sent.torque_N_m.y),
          f(record.sent.torque_N_m.z),
          f(record.penetration_m),
          f(record.gain),
          static_cast<float>(record.presentation),
          static_cast<float>(record.flags),
          f(record.lateness_ns * 1e-9),
          f(record.execution_ns * 1e-9)};
}

TickRecord record_of(std::int64_t time_ns,
                     std::span<const float, kRecordingColumns> values) noexcept {
  const auto vector_at = [&values](std::size_t column) {
    return glm::dvec3{values[column], values[column + 1], values[column + 2]};
  };
  TickRecord record{};
  record.probe.time_ns = time_ns;
  record.probe.position_m = vector_at(0);
  record.probe.orientation = glm::dquat{values[3], values[4], values[5], values[6]};
  record.probe.velocity_m_per_s = vector_at(7);
  record.probe.angular_velocity_rad_per_s = vector_at(10);
  record.probe.buttons = static_cast<std::uint32_t>(values[13]);
  record.rendered = {vector_at(14), vector_at(17)};
  record.sent = {vector_at(20), vector_at(23)};
  record.penetration_m = values[26];
  record.gain = values[27];
  record.presentation = static_cast<std::uint64_t>(values[28]);
  record.flags = static_cast<std::uint32_t>(values[29]);
  record.lateness_ns =
      static_cast<std::int32_t>(std::lround(static_cast<double>(values[30]) * 1e9));
  record.execution_ns =
      static_cast<std::int32_t>(std::lround(static_cast<double>(values[31]) * 1e9));
  return record;
}

TickRecord as_recorded(const TickRecord& record) noexcept {
  const std::array<float, kRecordingColumns> values = columns_of(record);
  return record_of(record.probe.time_ns, values);
}

std::vector<TickRecord> records_of(const Recording& recording, const std::filesystem::path& file) {
  const auto& expected = recording_columns();
  bool same = recording.columns.size() == expected.size() &&
              recording.header.columns.size() == expected.size();
  for (std::size_t column = 0; same && column < expected.size(); ++column) {
    same = recording.header.columns[column].name == expected[column].name;
  }
  if (!same) {
    throw ResultsError(
        "the recording" + (file.empty() ? std::string() : ' ' + file.string()) +
            " has columns that differ from those that this program writes; read it with the "
            "version that wrote it",
        file);
  }
  std::vector<TickRecord> records(recording.time_ns.size());
  std::array<float, kRecordingColumns> values{};
  for (std::size_t row = 0; row < records.size(); ++row) {
    for (std::size_t column = 0; column < kRecordingColumns; ++column) {
      values[column] = recording.columns[column][row];
    }
    records[row] = record_of(recording.time_ns[row], values);
  }
  return records;
}

}  // namespace asperity
