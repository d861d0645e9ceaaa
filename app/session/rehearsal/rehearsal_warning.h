// A difference between what a protocol requires and what a device was measured to do.

#pragma once

#include <optional>
#include <string>

#include "analysis/words/phrase.h"

namespace asperity {

/// A level of a varied parameter.
struct WarnedLevel {
  std::string stimulus{};  ///< its name without the level
  std::string parameter{};
  double value = 0.0;
};

/// A requirement that a device does not meet.
struct RehearsalWarning {
  /// "friction", "force_resolution", "position_resolution", "wavelength", "bandwidth", "stiffness", "coupling",
  /// "contact", "friction_damping", "friction_stiffness", "friction_not_compared", "workspace", "level_step", "position_step",
  /// "path_step"; "not_rehearsed" for a stimulus that could not be compared, or whose
  /// stiffness could not; "limit_" and "unmeasured_" with the name of an item that does not meet the protocol's limit,
  /// or that was not measured.
  std::string id{};
  std::string stimulus{};  ///< its name in the session; empty if the warning concerns all
  std::string pointer{};   ///< to the requirement: "/stimuli/rough", "/device/limits/friction_N"
  double asked =
      0.0;  ///< required; as `device` in SI units: N, m, Hz, N/m, N s/m; of an item its limit
  double device = 0.0;                 ///< measured
  Phrase text{};                       ///< a sentence with both numbers
  std::optional<WarnedLevel> level{};  ///< of a stimulus whose parameter is varied
};

/// A number as warnings show it, with three significant digits and no exponent: "0.300", "8000".
std::string in_three_digits(double value);

/// A positive number to two digits, up for a least value and down for a greatest one, so that the rounded remedy still
/// works.
double two_digits_up(double value);
double two_digits_down(double value);

}  // namespace asperity
