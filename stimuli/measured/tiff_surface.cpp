// Implements the decoding of a TIFF of floating-point numbers as heights.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "stimuli/measured/surface_decoding.h"
#include "stimuli/pictures/float_tiff.h"
#include "stimuli/pictures/photograph.h"

namespace asperity {

MeasuredSurface decode_tiff_surface(std::span<const std::byte> bytes, const SurfaceReading& reading,
                                    const std::string& name) {
  const auto refuse = [&name](const Phrase& sentence) {
    throw PhrasedRefusal(Phrase("%1: %2").with(name, sentence));
  };
  if (!reading.width_m || !reading.height_unit_m) {
    refuse(
        "a TIFF states neither the size of the surface nor the unit of its heights; give "
        "--width-m and --height-unit-m, such as 1e-6 for heights in µm.");
  }
  if (!std::isfinite(*reading.width_m) || *reading.width_m <= 0.0) {
    refuse("the width is " + number_text(*reading.width_m) +
           " m; give --width-m in metres, greater than 0.");
  }
  if (!std::isfinite(*reading.height_unit_m) || *reading.height_unit_m == 0.0) {
    refuse("the unit of the heights is " + number_text(*reading.height_unit_m) +
           " m; give --height-unit-m in metres, other than 0.");
  }
  const PictureFacts facts = inspect_float_tiff(bytes, name);
  const Phrase problem = points_problem(facts.columns, facts.rows);
  if (!problem.empty()) refuse(Phrase("%1.").with(problem));
  if (!can_expand_to(bytes.size(), facts.rows * facts.columns * sizeof(float))) {
    refuse("the file is too short for its number of points; copy or export it again.");
  }
  const GreyImage image = decode_float_tiff(bytes, name);
  MeasuredSurface surface{
      .rows = image.rows, .columns = image.columns, .has_further_pages = facts.has_further_pages};
  surface.pitch_x_m = *reading.width_m / static_cast<double>(image.columns);
  surface.pitch_y_m = surface.pitch_x_m;
  surface.heights_m.resize(image.values.size());
  std::transform(
      image.values.begin(), image.values.end(), surface.heights_m.begin(),
      [&reading](float value) { return static_cast<double>(value) * *reading.height_unit_m; });
  return surface;
}

}  // namespace asperity
