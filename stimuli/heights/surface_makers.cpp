// Declares parameters with limits, and requires enough samples for each structure.

#include "stimuli/heights/surface_makers.h"

#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"

namespace asperity {

Parameter length_parameter(std::string_view name, double minimum_m, double maximum_m,
                           double default_m, const Phrase& meaning) {
  Parameter parameter = plain_parameter(name, minimum_m, maximum_m, default_m, meaning);
  parameter.unit = "m";
  return parameter;
}

Parameter plain_parameter(std::string_view name, double minimum, double maximum,
                          double default_value, const Phrase& meaning) {
  return number_parameter(std::string(name), "1", minimum, maximum, default_value, meaning);
}

double pitch_of(const SurfaceCanvas& canvas) noexcept {
  return canvas.width_m / static_cast<double>(canvas.pixels);
}

void require_resolved(const ParameterValues& values, std::string_view name,
                      const SurfaceCanvas& canvas) {
  const double length_m = number_of(values, name);
  const double pitch_m = pitch_of(canvas);
  if (length_m < 2.0 * pitch_m) {
    throw PhrasedRefusal(phrase("Stimuli",
                                "%1 is %2 m, but %3 pixels over %4 m do not resolve lengths below "
                                "%5 m; increase pixels.")
                             .with(std::string(name), number_text(length_m),
                                   std::to_string(canvas.pixels), number_text(canvas.width_m),
                                   number_text(2.0 * pitch_m)));
  }
}

SurfacePoint point_of(const SurfaceCanvas& canvas, std::size_t row, std::size_t column) noexcept {
  const double pitch_m = pitch_of(canvas);
  const double middle = 0.5 * static_cast<double>(canvas.pixels - 1);
  return {.x_m = (static_cast<double>(column) - middle) * pitch_m,
          .y_m = (middle - static_cast<double>(row)) * pitch_m};
}

}  // namespace asperity
