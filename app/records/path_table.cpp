// Parses columns by name, derives missing velocities from positions, and writes forces as columns.

#include "app/records/path_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include <glm/gtc/quaternion.hpp>

#include "analysis/numbers/look_alikes.h"
#include "device/small_turn.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr std::array kNeeded{"time_s", "x_m", "y_m", "z_m"};
constexpr std::array kOrientation{"qw", "qx", "qy", "qz"};
constexpr std::array kVelocity{"vx_m_per_s",   "vy_m_per_s",   "vz_m_per_s",
                               "wx_rad_per_s", "wy_rad_per_s", "wz_rad_per_s"};

constexpr double kNanoseconds_per_s = 1e9;

/// The cells of a table as numbers, by column name.
class Numbers final {
 public:
  Numbers(const Table& table, const std::string& file_name) : table_(table), file_(file_name) {}

  std::optional<std::size_t> column(const std::string& name) const {
    const auto found = std::find(table_.columns.begin(), table_.columns.end(), name);
    if (found == table_.columns.end()) return {};
    return static_cast<std::size_t>(found - table_.columns.begin());
  }

  double at(std::size_t row, std::size_t column) const {
    const Cell& cell = table_.rows[row][column];
    const std::string* const text = std::get_if<std::string>(&cell);
    const std::optional<double> number = text != nullptr ? number_in(*text) : std::nullopt;
    if (!number || !std::isfinite(*number)) {
      throw std::runtime_error(
          file_ + ':' + std::to_string(row + 2) + ": the column " + table_.columns[column] +
          (text == nullptr ? " has no number; enter one"
                           : " has \"" + *text + "\", " + number_correction(*text)));
    }
    return *number;
  }

  /// The columns of a group, all or none.
  template <std::size_t N>
  std::optional<std::array<std::size_t, N>> group(const std::array<const char*, N>& names) const {
    std::array<std::size_t, N> columns{};
    std::size_t present = 0;
    std::string missing{};
    for (std::size_t i = 0; i < N; ++i) {
      if (const auto found = column(names[i])) {
        columns[i] = *found;
        ++present;
      } else {
        missing += std::string(missing.empty() ? "" : " ") + names[i];
      }
    }
    if (present == 0) return {};
    if (present < N) {
      throw std::runtime_error(
          file_ +
          ":1: the path has only some columns of a group; add the missing ones: " + missing);
    }
    return columns;
  }

 private:
  const Table& table_;
  const std::string& file_;
};

void derive_velocities(std::vector<ProbeState>& path) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, path.size() - 1);
    const double dt_s = static_cast<double>(path[after].time_ns - path[before].time_ns) * 1e-9;
    path[i].velocity_m_per_s = (path[after].position_m - path[before].position_m) / dt_s;
    path[i].angular_velocity_rad_per_s =
        small_turn_rad(path[before].orientation, path[after].orientation) / dt_s;
  }
}

}  // namespace

std::vector<ProbeState> path_in(std::string_view tsv, const std::string& file_name) {
  const Table table = read_tsv(tsv, file_name);
  const Numbers numbers(table, file_name);
  std::set<std::string> known(kNeeded.begin(), kNeeded.end());
  known.insert(kOrientation.begin(), kOrientation.end());
  known.insert(kVelocity.begin(), kVelocity.end());
  for (const std::string& column : table.columns) {
    if (!known.contains(column)) {
      throw std::runtime_error(file_name + ":1: unknown column \"" + column +
                               "\"; rename or remove it. A path has the columns time_s x_m y_m "
                               "z_m, and optionally qw qx qy qz and vx_m_per_s … wz_rad_per_s");
    }
  }
  const auto needed = numbers.group(kNeeded);
  if (!needed) {
    throw std::runtime_error(file_name +
                             ":1: a path needs the columns time_s x_m y_m z_m; add them");
  }
  const auto orientation = numbers.group(kOrientation);
  const auto velocity = numbers.group(kVelocity);
  if (table.rows.size() < 2) {
    throw std::runtime_error(file_name + ": a path needs at least two rows; add rows");
  }
  std::vector<ProbeState> path(table.rows.size());
  for (std::size_t row = 0; row < path.size(); ++row) {
    const auto at = [&](const auto& columns, std::size_t i) { return numbers.at(row, columns[i]); };
    ProbeState& probe = path[row];
    probe.time_ns = std::llround(at(*needed, 0) * 1e9);
    if (row > 0 && probe.time_ns <= path[row - 1].time_ns) {
      throw std::runtime_error(file_name + ':' + std::to_string(row + 2) +
                               ": time_s does not increase; sort the rows by time, each time once");
    }
    probe.position_m = {at(*needed, 1), at(*needed, 2), at(*needed, 3)};
    if (orientation) {
      const glm::dquat q{at(*orientation, 0), at(*orientation, 1), at(*orientation, 2),
                         at(*orientation, 3)};
      const double length = glm::length(q);
      if (length < 1e-6) {
        throw std::runtime_error(
            file_name + ':' + std::to_string(row + 2) +
            ": qw qx qy qz are all zero, which is not a rotation; enter a unit quaternion");
      }
      probe.orientation = q / length;
    }
    if (velocity) {
      probe.velocity_m_per_s = {at(*velocity, 0), at(*velocity, 1), at(*velocity, 2)};
      probe.angular_velocity_rad_per_s = {at(*velocity, 3), at(*velocity, 4), at(*velocity, 5)};
    }
  }
  if (!velocity) derive_velocities(path);
  return path;
}

std::string position_warning(std::span<const ProbeState> path) {
  // The workspaces of devices reach to 0.2 m from their middle, those of the largest to 0.4 m.
  constexpr double kFarthest_m = 0.4;
  double farthest_m = 0.0;
  std::string axis{};
  for (const ProbeState& probe : path) {
    for (int i = 0; i < 3; ++i) {
      if (std::abs(probe.position_m[i]) <= std::abs(farthest_m)) continue;
      farthest_m = probe.position_m[i];
      axis = kNeeded[static_cast<std::size_t>(i) + 1];
    }
  }
  if (std::abs(farthest_m) <= kFarthest_m) return {};
  return axis + " reaches " + text_of_number(farthest_m) +
         " m, farther than a hand moves at a device; if the positions are in millimetres, divide "
         "them by 1000";
}

std::string forces_tsv(std::span<const ProbeState> path, std::span<const RenderedTick> forces) {
  Table table{};
  table.columns = {"time_s", "fx_N", "fy_N", "fz_N", "tx_N_m", "ty_N_m", "tz_N_m", "penetration_m"};
  table.rows.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Wrench& wrench = forces[i].wrench;
    // Divided: the quotient of two integers is the double nearest to the intended decimal, 1.198; a
    // product with the inexact 1e-9 is off by a bit, 1.1980000000000002.
    table.rows.push_back({static_cast<double>(path[i].time_ns) / kNanoseconds_per_s,
                          wrench.force_N.x, wrench.force_N.y, wrench.force_N.z, wrench.torque_N_m.x,
                          wrench.torque_N_m.y, wrench.torque_N_m.z, forces[i].penetration_m});
  }
  return tsv_of(table);
}

Table tool_table(std::span<const ProbeState> path, const ToolAlongPath& along) {
  Table table{.columns = {"time_s", "x_m", "y_m", "z_m", "qw", "qx", "qy", "qz", "rx_rad", "ry_rad",
                          "rz_rad", "fx_N", "fy_N", "fz_N", "tx_N_m", "ty_N_m", "tz_N_m",
                          "penetration_m"}};
  table.rows.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const TipPose& tool = along.tools[i];
    const glm::dvec3 turn_rad = small_turn_rad(glm::dquat{1.0, 0.0, 0.0, 0.0}, tool.orientation);
    const Wrench& wrench = along.ticks[i].wrench;
    table.rows.push_back({static_cast<double>(path[i].time_ns) / kNanoseconds_per_s,
                          tool.position_m.x, tool.position_m.y, tool.position_m.z,
                          tool.orientation.w, tool.orientation.x, tool.orientation.y,
                          tool.orientation.z, turn_rad.x, turn_rad.y, turn_rad.z, wrench.force_N.x,
                          wrench.force_N.y, wrench.force_N.z, wrench.torque_N_m.x,
                          wrench.torque_N_m.y, wrench.torque_N_m.z, along.ticks[i].penetration_m});
  }
  return table;
}

double rate_Hz_of(std::span<const ProbeState> path) {
  std::vector<std::int64_t> steps_ns{};
  for (std::size_t i = 1; i < path.size(); ++i) {
    steps_ns.push_back(path[i].time_ns - path[i - 1].time_ns);
  }
  const auto middle = steps_ns.begin() + static_cast<std::ptrdiff_t>(steps_ns.size() / 2);
  std::nth_element(steps_ns.begin(), middle, steps_ns.end());
  return 1e9 / static_cast<double>(*middle);
}

}  // namespace asperity
