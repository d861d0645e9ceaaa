// Implements regular patterns and noise: sinusoid, grating, cones, noise.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "stimuli/heights/spectral_noise.h"
#include "stimuli/heights/surface_makers.h"

namespace asperity {

namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

template <class HeightAt>
Heights heights_from(const SurfaceCanvas& canvas, const HeightAt& height_at) {
  Heights heights_m;
  heights_m.reserve(canvas.pixels * canvas.pixels);
  for (std::size_t i = 0; i < canvas.pixels; ++i) {
    for (std::size_t j = 0; j < canvas.pixels; ++j) {
      heights_m.push_back(static_cast<float>(height_at(point_of(canvas, i, j))));
    }
  }
  return heights_m;
}

Heights make_sinusoid(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "spacing_m", canvas);
  const double amplitude_m = number_of(values, "amplitude_m");
  const double angle_rad = number_of(values, "angle_rad");
  const double x_rad_per_m = kTurn_rad / number_of(values, "spacing_m") * std::cos(angle_rad);
  const double y_rad_per_m = kTurn_rad / number_of(values, "spacing_m") * std::sin(angle_rad);
  return heights_from(canvas, [&](const SurfacePoint& p) {
    return amplitude_m * std::sin(x_rad_per_m * p.x_m + y_rad_per_m * p.y_m);
  });
}

Heights make_grating(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "spacing_m", canvas);
  const double spacing_m = number_of(values, "spacing_m");
  const double height_m = number_of(values, "height_m");
  const double half_ridge_m = 0.5 * number_of(values, "ridge_width_m");
  const double flank_m = number_of(values, "flank_width_m");
  if (2.0 * (half_ridge_m + flank_m) > spacing_m) {
    throw PhrasedRefusal(phrase("Stimuli",
                                "grating: ridge_width_m and two flank_width_m together are wider "
                                "than spacing_m; make them narrower or the spacing wider."));
  }
  return heights_from(canvas, [&](const SurfacePoint& p) {
    const double from_ridge_m = std::abs(std::remainder(p.x_m, spacing_m));
    return height_m * std::clamp(1.0 - (from_ridge_m - half_ridge_m) / flank_m, 0.0, 1.0);
  });
}

/// A square lattice of columns and rows on a canvas, turned by an angle.
///
/// A turned lattice continues across the borders of a canvas of width W if W·(cos θ, −sin θ)/L = (a, −b) for whole a and
/// b: the canvas then has a² + b² of its points. With g the greatest common divisor of a and b, the first (a² + b²)/g points
/// of g neighbouring rows are all different ones (modulo the canvas), because a row meets itself after (a² + b²)/g points.
struct ConeLattice {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double cosine = 1.0;
  double sine = 0.0;
};

ConeLattice cone_lattice(const ParameterValues& values, const SurfaceCanvas& canvas) {
  const double spacings = canvas.width_m / number_of(values, "spacing_m");
  const double angle_rad = number_of(values, "angle_rad");
  if (angle_rad == 0.0) {
    // The tolerance covers rounding errors, so that 0.1 m contains fifty spacings of 0.002 m.
    const auto count = static_cast<std::size_t>(std::floor(spacings + 1e-9));
    return {.columns = count, .rows = count};
  }
  constexpr double kSeamless = 1e-3;  // of a spacing
  const double along = spacings * std::cos(angle_rad);
  const double across = spacings * std::sin(angle_rad);
  if (std::abs(along - std::round(along)) > kSeamless ||
      std::abs(across - std::round(across)) > kSeamless || std::round(across) == 0.0) {
    throw PhrasedRefusal(
        phrase(
            "Stimuli",
            "cones: rows at angle_rad %1 do not continue across the borders: the width contains "
            "%2 spacings of a row along x and %3 along y, which must be whole numbers; choose "
            "for example angle_rad 0.643501 (3 to 4) and a width of a multiple of five spacings.")
            .with(number_text(angle_rad), number_text(along), number_text(across)));
  }
  const auto a = static_cast<std::size_t>(std::round(along));
  const auto b = static_cast<std::size_t>(std::round(across));
  const std::size_t rows = std::gcd(a, b);
  const double length = std::hypot(std::round(along), std::round(across));
  return {.columns = (a * a + b * b) / rows,
          .rows = rows,
          .cosine = std::round(along) / length,
          .sine = std::round(across) / length};
}

Heights make_cones(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "spacing_m", canvas);
  const double spacing_m = number_of(values, "spacing_m");
  const double height_m = number_of(values, "height_m");
  const double top_share =
      number_of(values, "top_diameter_m") / number_of(values, "base_diameter_m");
  if (top_share >= 1.0) {
    throw PhrasedRefusal(phrase(
        "Stimuli", "cones: top_diameter_m is not smaller than base_diameter_m; make it smaller."));
  }
  const double shift_m = number_of(values, "jitter") * spacing_m;
  Random random = Random(canvas.seed).split("cones");
  const auto shifted_m = [&](std::size_t index) {
    return (static_cast<double>(index) + 0.5) * spacing_m - 0.5 * canvas.width_m +
           shift_m * (2.0 * random.uniform() - 1.0);
  };
  Heights heights_m(canvas.pixels * canvas.pixels, 0.0F);
  const ConeLattice lattice = cone_lattice(values, canvas);
  for (std::size_t row = 0; row < lattice.rows; ++row) {
    for (std::size_t column = 0; column < lattice.columns; ++column) {
      const double along_m = shifted_m(column);
      const double across_m = shifted_m(row);
      raise(heights_m, canvas,
            {.at = {.x_m = along_m * lattice.cosine - across_m * lattice.sine,
                    .y_m = along_m * lattice.sine + across_m * lattice.cosine},
             .radius_m = 0.5 * number_of(values, "base_diameter_m"),
             .height_m = height_m},
            [&](double distance) { return std::min(1.0, (1.0 - distance) / (1.0 - top_share)); });
    }
  }
  return heights_m;
}

Heights make_noise(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "shortest_wavelength_m", canvas);
  const double lowest_per_m = 1.0 / number_of(values, "longest_wavelength_m");
  const double highest_per_m = 1.0 / number_of(values, "shortest_wavelength_m");
  const double exponent = number_of(values, "exponent");
  if (lowest_per_m >= highest_per_m) {
    throw PhrasedRefusal(phrase("Stimuli",
                                "noise: shortest_wavelength_m is not shorter than "
                                "longest_wavelength_m; make it shorter."));
  }
  Heights heights_m = spectral_noise(canvas, "noise", [&](const Wavenumber& at) {
    const double wavenumber_per_m = std::hypot(at.x_per_m, at.y_per_m);
    if (wavenumber_per_m < lowest_per_m || wavenumber_per_m > highest_per_m) return 0.0;
    return std::pow(wavenumber_per_m / lowest_per_m, -0.5 * exponent);
  });
  const auto rms_m = static_cast<float>(number_of(values, "rms_m"));
  for (float& height_m : heights_m) height_m *= rms_m;
  return heights_m;
}

}  // namespace

std::vector<SurfaceMaker> pattern_makers() {
  return {
      {{"sinusoid",
        "h = A sin(2π(x cos θ + y sin θ)/L)",
        {length_parameter("amplitude_m", 0.0, 0.005, 2e-4,
                          phrase("Stimuli", "A: half the height from trough to crest")),
         length_parameter("spacing_m", 1e-4, 0.05, 0.002,
                          phrase("Stimuli", "L: distance from crest to crest")),
         plain_parameter("angle_rad", -3.1415926535897931, 3.1415926535897931, 0.0,
                         phrase("Stimuli", "θ: direction across the crests, from +x towards +y"))}},
       make_sinusoid},
      {{"grating",
        phrase("Stimuli",
               "straight ridges along y with flat tops and straight flanks; a ridge at x = 0"),
        {length_parameter("spacing_m", 1e-4, 0.05, 0.002,
                          phrase("Stimuli", "distance from ridge to ridge")),
         length_parameter("height_m", 0.0, 0.005, 4e-4,
                          phrase("Stimuli", "height from groove to top")),
         length_parameter("ridge_width_m", 0.0, 0.05, 5e-4,
                          phrase("Stimuli", "width of the flat top")),
         length_parameter("flank_width_m", 1e-5, 0.05, 3e-4,
                          phrase("Stimuli", "width of one flank, along x"))}},
       make_grating},
      {{"cones",
        phrase("Stimuli", "truncated cones on a square lattice, shifted at random (dithered)"),
        {length_parameter("spacing_m", 2e-4, 0.05, 0.0025,
                          phrase("Stimuli", "distance between neighbouring cones")),
         length_parameter("height_m", 0.0, 0.005, 4e-4, phrase("Stimuli", "height of a cone")),
         length_parameter("top_diameter_m", 0.0, 0.05, 4e-4,
                          phrase("Stimuli", "diameter of the flat top")),
         length_parameter("base_diameter_m", 2e-4, 0.05, 0.0012,
                          phrase("Stimuli", "diameter of the base")),
         plain_parameter(
             "jitter", 0.0, 0.5, 0.15,
             phrase("Stimuli",
                    "largest shift along and across the rows, as a fraction of the spacing")),
         plain_parameter(
             "angle_rad", 0.0, 0.25 * std::numbers::pi, 0.0,
             phrase("Stimuli",
                    "direction of the rows, from +x towards +y; the rows must continue across "
                    "the borders (0.643501, 3 to 4, on a multiple of five spacings)"))}},
       make_cones},
      {{"noise",
        phrase("Stimuli",
               "isotropic Gaussian noise of power spectral density (per area of the wavenumber "
               "plane) ∝ "
               "wavenumber^−exponent between two wavelengths"),
        {length_parameter("rms_m", 0.0, 0.005, 1e-4, phrase("Stimuli", "RMS of the heights")),
         plain_parameter("exponent", 0.0, 6.0, 3.0, phrase("Stimuli", "exponent of the power law")),
         length_parameter("shortest_wavelength_m", 1e-4, 0.1, 4e-4,
                          phrase("Stimuli", "shortest wavelength of the noise")),
         length_parameter("longest_wavelength_m", 1e-4, 1.0, 0.01,
                          phrase("Stimuli", "longest wavelength of the noise"))}},
       make_noise},
  };
}

}  // namespace asperity
