// Matches the end of the name with the known units, the longer ones first.

#include "stimuli/properties/unit_of_name.h"

#include <array>
#include <utility>

namespace asperity {

std::optional<std::string> unit_at_end_of(std::string_view name) {
  // An ending that contains another stands before it.
  static constexpr std::array<std::pair<std::string_view, const char*>, 14> kUnits{
      {{"_N_s_per_m", "N s/m"},
       {"_N_per_m", "N/m"},
       {"_N_m", "N m"},
       {"_m_per_s2", "m/s2"},
       {"_m_per_s", "m/s"},
       {"_rad_per_s", "rad/s"},
       {"_per_m", "1/m"},
       {"_per_s", "1/s"},
       {"_rad", "rad"},
       {"_kg", "kg"},
       {"_Hz", "Hz"},
       {"_N", "N"},
       {"_m", "m"},
       {"_s", "s"}}};
  for (const auto& [ending, unit] : kUnits) {
    if (name.ends_with(ending)) return unit;
  }
  return std::nullopt;
}

}  // namespace asperity
