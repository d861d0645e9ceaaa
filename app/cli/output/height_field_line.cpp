// Joins size, pitch and heights with the units of displayed numbers.

#include "app/cli/output/height_field_line.h"

#include "analysis/numbers/number_text.h"
#include "app/cli/output/terminal.h"
#include "app/findings/outcome/display_number.h"

namespace asperity {

std::string height_field_line(const std::filesystem::path& out, const HeightField& field) {
  const double rms_um = field.rms_m() * 1e6;
  const int decimals = decimals_of_height(rms_um, 1);
  return out.string() + ": " + std::to_string(field.grid().columns) + " × " +
         std::to_string(field.grid().rows) + " samples, pitch " +
         fixed(field.grid().pitch_m * 1e6, 1) + " µm, height " +
         display_signed(field.minimum_m() * 1e6, decimals) + " to " +
         display_signed(field.maximum_m() * 1e6, decimals) + " µm, RMS " + fixed(rms_um, decimals) +
         " µm\n";
}

}  // namespace asperity
