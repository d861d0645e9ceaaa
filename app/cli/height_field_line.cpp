#include "app/cli/height_field_line.h"

#include "analysis/number_text.h"
#include "app/cli/terminal.h"
#include "app/findings/reading_number.h"

namespace asperity {

std::string height_field_line(const std::filesystem::path& out, const HeightField& field) {
  return out.string() + ": " + std::to_string(field.grid().columns) + " × " +
         std::to_string(field.grid().rows) + " samples, pitch " +
         fixed(field.grid().pitch_m * 1e6, 1) + " µm, height " +
         reading_signed(field.minimum_m() * 1e6, 1) + " to " +
         reading_signed(field.maximum_m() * 1e6, 1) + " µm, RMS " + fixed(field.rms_m() * 1e6, 1) +
         " µm\n";
}

}  // namespace asperity
