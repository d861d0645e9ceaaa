// Matches the end of the name with the known units, the longer ones first.

#include "analysis/numbers/unit_of_name.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

struct KnownUnit {
  std::string_view ending{};
  std::string_view unit{};
  std::string_view in_files = unit;
};
// An ending that contains another stands before it.
constexpr std::array kKnownUnits{KnownUnit{"_N_m_s_per_rad", "N m s/rad"},
                                 KnownUnit{"_N_m_per_rad", "N m/rad"},
                                 KnownUnit{"_N_s_per_m", "N s/m"},
                                 KnownUnit{"_N_per_m", "N/m"},
                                 KnownUnit{"_N_m", "N m"},
                                 KnownUnit{"_m_per_s2", "m/s²", "m/s2"},
                                 KnownUnit{"_m_per_s", "m/s"},
                                 KnownUnit{"_rad_per_s", "rad/s"},
                                 KnownUnit{"_per_m", "1/m"},
                                 KnownUnit{"_per_s", "1/s"},
                                 KnownUnit{"_kg_m2", "kg m²", "kg m2"},
                                 KnownUnit{"_kg", "kg"},
                                 KnownUnit{"_rad", "rad"},
                                 KnownUnit{"_Hz", "Hz"},
                                 KnownUnit{"_Pa", "Pa"},
                                 KnownUnit{"_dB", "dB"},
                                 KnownUnit{"_N", "N"},
                                 KnownUnit{"_m", "m"},
                                 KnownUnit{"_s", "s"}};

/// One without an ending and a unit for a name that ends in none.
KnownUnit unit_at_end_of(std::string_view name) {
  const auto* const found = std::ranges::find_if(kKnownUnits, [name](const KnownUnit& known) {
    return name.size() > known.ending.size() && name.ends_with(known.ending);
  });
  return found == kKnownUnits.end() ? KnownUnit{} : *found;
}

}  // namespace

NamedQuantity named_quantity(std::string_view name) {
  const KnownUnit known = unit_at_end_of(name);
  name.remove_suffix(known.ending.size());
  return {.quantity = name, .unit = known.unit};
}

std::string unit_in_files(std::string_view name) {
  const KnownUnit known = unit_at_end_of(name);
  return known.unit.empty() ? "1" : std::string(known.in_files);
}

}  // namespace asperity
