// Implements the recording of a texture that is computed from a relief.

#include "renderers/recordings/relief_recording.h"

#include <cstddef>
#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "device/refusal.h"

namespace asperity {

TextureRecording recording_of_relief(const HeightField& field, const ReliefStrokes& strokes) {
  require_positive("ReliefStrokes::normal_N", strokes.normal_N);
  require_positive("ReliefStrokes::rate_Hz", strokes.rate_Hz);
  const HeightField::Grid& grid = field.grid();
  const double width_m = static_cast<double>(grid.columns - 1) * grid.pitch_m;
  const double length_m = static_cast<double>(grid.rows - 1) * grid.pitch_m;
  TextureRecording recording{};
  for (const double speed_m_per_s : strokes.speeds_m_per_s) {
    require_positive("ReliefStrokes::speeds_m_per_s", speed_m_per_s);
    const double way_m = speed_m_per_s / strokes.rate_Hz;
    const auto count = static_cast<std::size_t>(width_m / way_m);
    if (count < kFewestSamplesOfStroke) {
      throw PhrasedRefusal(
          phrase(
              "Models",
              "the relief is %1 mm wide, too narrow for %2 samples at %3 m/s and %4 Hz; choose a "
              "lower speed or a higher sampling rate")
              .with(number_text(width_m * 1e3), std::to_string(kFewestSamplesOfStroke),
                    number_text(speed_m_per_s), number_text(strokes.rate_Hz)));
    }
    for (const double part : {-0.25, 0.0, 0.25}) {
      RecordedStroke stroke{};
      double before_m = field.sample(-0.5 * width_m, part * length_m, Tiling::bounded).height_m;
      for (std::size_t i = 0; i < count; ++i) {
        const double path_m = static_cast<double>(i) * way_m;
        const double after_m =
            field.sample(-0.5 * width_m + path_m + way_m, part * length_m, Tiling::bounded)
                .height_m;
        stroke.time_s.push_back(static_cast<double>(i) / strokes.rate_Hz);
        stroke.path_m.push_back(path_m);
        stroke.normal_N.push_back(strokes.normal_N);
        stroke.force_N.push_back(strokes.normal_N * (after_m - before_m) / way_m);
        before_m = after_m;
      }
      recording.strokes.push_back(std::move(stroke));
    }
  }
  return recording;
}

}  // namespace asperity
