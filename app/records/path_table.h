// Reads and writes paths of a probe and forces along them as tables.

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device/probe_state.h"
#include "renderers/force/rendered_tick.h"
#include "renderers/offline/along_path.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// A path: `time_s x_m y_m z_m`, optionally `qw qx qy qz` and
/// `vx_m_per_s vy_m_per_s vz_m_per_s wx_rad_per_s wy_rad_per_s wz_rad_per_s`. Velocities that are
/// absent are central differences of position and orientation (one-sided at the ends).
///
/// Errors: std::runtime_error naming the file, line and column: a column that is missing or
/// unknown, a cell that is not a finite number, time that does not increase, fewer than two rows.
std::vector<ProbeState> path_in(std::string_view tsv, const std::string& file_name);

/// A sentence on a path that reaches farther than a hand moves at a device, as one in millimetres does; empty for others.
std::string position_warning(std::span<const ProbeState> path);

/// `time_s fx_N fy_N fz_N tx_N_m ty_N_m tz_N_m penetration_m`, in the fewest digits that give the
/// same numbers when read.
std::string forces_tsv(std::span<const ProbeState> path, std::span<const RenderedTick> forces);

/// The pose of the tool with its force, a row for each sample of the path:
/// `time_s x_m y_m z_m qw qx qy qz rx_rad ry_rad rz_rad fx_N fy_N fz_N tx_N_m ty_N_m tz_N_m penetration_m`. The position is
/// that of the tool's tip; `rx_rad` to `rz_rad` are its rotation vector, axis times angle (at most π), from the orientation
/// of the frame. The torque is about the tip of the device.
Table tool_table(std::span<const ProbeState> path, const ToolAlongPath& along);

/// Samples per second of a path: the reciprocal of its median step.
double rate_Hz_of(std::span<const ProbeState> path);

}  // namespace asperity
