#include "app/cli/output/height_field_line.h"

#include <algorithm>
#include <cmath>

#include "analysis/number_text.h"
#include "app/cli/output/terminal.h"
#include "app/findings/reading_number.h"

namespace asperity {

std::string height_field_line(const std::filesystem::path& out, const HeightField& field) {
  // Three significant digits below 10 µm: with one decimal, a relief of nanometres would have an RMS of 0.0 µm.
  const double rms_um = field.rms_m() * 1e6;
  constexpr double kCoarse_um = 10.0;
  const int decimals = rms_um > 0.0 && rms_um < kCoarse_um
                           ? std::min(2 - static_cast<int>(std::floor(std::log10(rms_um))), 9)
                           : 1;
  return out.string() + ": " + std::to_string(field.grid().columns) + " × " +
         std::to_string(field.grid().rows) + " samples, pitch " +
         fixed(field.grid().pitch_m * 1e6, 1) + " µm, height " +
         reading_signed(field.minimum_m() * 1e6, decimals) + " to " +
         reading_signed(field.maximum_m() * 1e6, decimals) + " µm, RMS " + fixed(rms_um, decimals) +
         " µm\n";
}

}  // namespace asperity
