// Implements five materials composed of patterns and noise: metal, stone, wood, brick, sandpaper.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "stimuli/heights/spectral_noise.h"
#include "stimuli/heights/surface_makers.h"

namespace asperity {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Noise in long streaks along y: a Gaussian over the logarithm of wavelength across them, a Gaussian along them.
Heights streaks(const SurfaceCanvas& canvas, std::string_view stream, const WavelengthBell& across,
                double length_m) {
  return spectral_noise(canvas, stream, [&](const Wavenumber& at) {
    const double along = at.y_per_m * length_m;
    return amplitude_at(across, at.x_per_m) * std::exp(-0.5 * along * along);
  });
}

Heights grainy(const SurfaceCanvas& canvas, std::string_view stream, const WavelengthBell& bell) {
  return spectral_noise(canvas, stream, [&](const Wavenumber& at) {
    return amplitude_at(bell, std::hypot(at.x_per_m, at.y_per_m));
  });
}

Heights make_metal(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "spacing_m", canvas);
  Heights heights_m =
      streaks(canvas, "brushing", {.centre_m = number_of(values, "spacing_m"), .spread = 0.2},
              number_of(values, "scratch_length_m"));
  const auto rms_m = static_cast<float>(number_of(values, "rms_m"));
  for (float& height_m : heights_m) height_m *= rms_m;
  return heights_m;
}

Heights make_stone(const ParameterValues& values, const SurfaceCanvas& canvas) {
  constexpr double kLongest_m = 0.006;
  const double exponent = number_of(values, "exponent");
  const double shortest_m = 4.0 * pitch_of(canvas);
  const Heights relief = spectral_noise(canvas, "relief", [&](const Wavenumber& at) {
    const double wavenumber_per_m = std::hypot(at.x_per_m, at.y_per_m);
    if (wavenumber_per_m * kLongest_m < 1.0 || wavenumber_per_m * shortest_m > 1.0) return 0.0;
    return std::pow(wavenumber_per_m * kLongest_m, -0.5 * exponent);
  });
  const Heights pits = grainy(canvas, "pits", {.centre_m = 0.003, .spread = 0.3});
  const double rms_m = number_of(values, "rms_m");
  const double pit_depth_m = number_of(values, "pit_depth_m");
  Heights heights_m(relief.size());
  for (std::size_t i = 0; i < relief.size(); ++i) {
    // A pit begins where the second noise exceeds 1.2 standard deviations and has its full depth at 2.2.
    const double pit = glm::smoothstep(0.0, 1.0, static_cast<double>(pits[i]) - 1.2);
    heights_m[i] = static_cast<float>(rms_m * static_cast<double>(relief[i]) - pit_depth_m * pit);
  }
  return heights_m;
}

Heights make_wood(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "spacing_m", canvas);
  const double spacing_m = number_of(values, "spacing_m");
  // The rings shift slowly across the board and hardly along it.
  const Heights warp = spectral_noise(canvas, "warp", [](const Wavenumber& at) {
    const double across = at.x_per_m * 0.02;
    const double along = at.y_per_m * 0.05;
    return std::exp(-0.5 * (across * across + along * along));
  });
  const Heights pores = streaks(canvas, "pores", {.centre_m = 6e-4, .spread = 0.25}, 0.006);
  const double waviness_m = number_of(values, "waviness_m");
  const double ring_height_m = number_of(values, "ring_height_m");
  const double pore_rms_m = number_of(values, "pore_rms_m");
  Heights heights_m;
  heights_m.reserve(warp.size());
  for (std::size_t i = 0; i < canvas.pixels; ++i) {
    for (std::size_t j = 0; j < canvas.pixels; ++j) {
      const std::size_t at = i * canvas.pixels + j;
      const double phase_rad =
          kTwoPi * (point_of(canvas, i, j).x_m + waviness_m * static_cast<double>(warp[at])) /
          spacing_m;
      // Soft early wood wears away; the profile rises slowly to the hard rim of late wood.
      const double ring = 0.5 + 0.5 * std::cos(phase_rad + 0.6 * std::sin(phase_rad + 0.8));
      heights_m.push_back(
          static_cast<float>(ring_height_m * ring + pore_rms_m * static_cast<double>(pores[at])));
    }
  }
  return heights_m;
}

Heights make_brick(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "joint_width_m", canvas);
  const double length_m = number_of(values, "brick_length_m");
  const double course_m = number_of(values, "course_height_m");
  const double joint_m = number_of(values, "joint_width_m");
  const double depth_m = number_of(values, "joint_depth_m");
  const double face_rms_m = number_of(values, "face_rms_m");
  const double edge_m = 0.4 * joint_m;  // the rounded edge of a brick has this width
  const Heights face = grainy(canvas, "face", {.centre_m = 0.002, .spread = 0.25});
  Heights heights_m;
  heights_m.reserve(face.size());
  for (std::size_t i = 0; i < canvas.pixels; ++i) {
    for (std::size_t j = 0; j < canvas.pixels; ++j) {
      const SurfacePoint p = point_of(canvas, i, j);
      // The middle of the picture is the middle of a course, so that a stroke across it meets bricks.
      const double up = (p.y_m + 0.5 * canvas.width_m) / course_m + 0.5;
      const double course = std::floor(up);
      const double stagger = std::fmod(course, 2.0) == 0.0 ? 0.0 : 0.5;  // running bond
      const double along = (p.x_m + 0.5 * canvas.width_m) / length_m + stagger;
      const double to_bed_m = (0.5 - std::abs(up - course - 0.5)) * course_m;
      const double to_head_m = (0.5 - std::abs(along - std::floor(along) - 0.5)) * length_m;
      const double into_brick_m = std::min(to_bed_m, to_head_m) - 0.5 * joint_m;
      const double brick = glm::smoothstep(0.0, 1.0, into_brick_m / edge_m + 0.5);
      // Mortar is smoother than the face of a brick.
      const double roughness_m = face_rms_m * (0.3 + 0.7 * brick);
      heights_m.push_back(
          static_cast<float>(depth_m * (brick - 1.0) +
                             roughness_m * static_cast<double>(face[i * canvas.pixels + j])));
    }
  }
  return heights_m;
}

Heights make_sandpaper(const ParameterValues& values, const SurfaceCanvas& canvas) {
  require_resolved(values, "grain_spacing_m", canvas);
  const double spacing_m = number_of(values, "grain_spacing_m");
  const double height_m = number_of(values, "grain_height_m");
  Random random = Random(canvas.seed).split("grains");
  Heights heights_m(canvas.pixels * canvas.pixels, 0.0F);
  // The number of grains is the number of spacings that fit; they are spread over the width to avoid a seam.
  const auto count =
      static_cast<std::size_t>(std::max(1.0, std::round(canvas.width_m / spacing_m)));
  const double cell_m = canvas.width_m / static_cast<double>(count);
  for (std::size_t row = 0; row < count; ++row) {
    for (std::size_t column = 0; column < count; ++column) {
      const double x_m = (static_cast<double>(column) + 0.35 * random.uniform()) * cell_m;
      const double y_m = (static_cast<double>(row) + 0.35 * random.uniform()) * cell_m;
      const double size = 0.75 + 0.25 * random.uniform();
      raise(heights_m, canvas,
            {.at = {.x_m = x_m - 0.5 * canvas.width_m, .y_m = y_m - 0.5 * canvas.width_m},
             .radius_m = 0.6 * size * spacing_m,
             .height_m = size * height_m},
            [](double distance) { return 1.0 - distance * distance; });
    }
  }
  return heights_m;
}

}  // namespace

std::vector<SurfaceMaker> material_makers() {
  return {
      {{"metal",
        phrase("Stimuli", "brushed metal: fine scratches along y"),
        {length_parameter("rms_m", 0.0, 0.001, 2e-5, phrase("Stimuli", "RMS of the heights")),
         length_parameter(
             "spacing_m", 1e-4, 0.01, 5e-4,
             phrase("Stimuli", "most frequent distance between neighbouring scratches")),
         length_parameter("scratch_length_m", 1e-3, 0.1, 0.01,
                          phrase("Stimuli", "length over which a scratch keeps its direction"))}},
       make_metal},
      {{"stone",
        phrase("Stimuli",
               "rough stone: isotropic relief of every wavelength up to 6 mm, with pits"),
        {length_parameter("rms_m", 0.0, 0.002, 1.2e-4,
                          phrase("Stimuli", "RMS of the relief, without the pits")),
         plain_parameter("exponent", 0.0, 6.0, 2.6,
                         phrase("Stimuli", "exponent of its power spectral density")),
         length_parameter("pit_depth_m", 0.0, 0.003, 2e-4,
                          phrase("Stimuli", "depth of the deepest pits"))}},
       make_stone},
      {{"wood",
        phrase("Stimuli", "worn plank: growth rings along y, with fine pores"),
        {length_parameter("spacing_m", 2e-4, 0.05, 0.0025,
                          phrase("Stimuli", "distance from ring to ring")),
         length_parameter("ring_height_m", 0.0, 0.002, 2.5e-4,
                          phrase("Stimuli", "height from earlywood to latewood")),
         length_parameter("waviness_m", 0.0, 0.02, 7e-4,
                          phrase("Stimuli", "RMS of the rings' displacement along x")),
         length_parameter("pore_rms_m", 0.0, 5e-4, 8e-6,
                          phrase("Stimuli", "RMS of the pores' relief"))}},
       make_wood},
      {{"brick",
        phrase("Stimuli",
               "small bricks in running bond with recessed mortar joints and rough faces"),
        {length_parameter("brick_length_m", 0.002, 0.5, 0.02,
                          phrase("Stimuli", "length of a brick, including one joint")),
         length_parameter("course_height_m", 0.001, 0.5, 0.01,
                          phrase("Stimuli", "height of a course, including one joint")),
         length_parameter("joint_width_m", 2e-4, 0.05, 0.0016,
                          phrase("Stimuli", "width of the mortar joints")),
         length_parameter("joint_depth_m", 0.0, 0.005, 4e-4,
                          phrase("Stimuli", "depth of the mortar below the faces")),
         length_parameter("face_rms_m", 0.0, 0.001, 5e-5,
                          phrase("Stimuli", "RMS of the faces' relief"))}},
       make_brick},
      {{"sandpaper",
        phrase("Stimuli", "coarse sandpaper: round grains of several sizes, close together"),
        {length_parameter("grain_spacing_m", 2e-4, 0.01, 9e-4,
                          phrase("Stimuli", "mean distance between grains")),
         length_parameter("grain_height_m", 0.0, 0.002, 2.5e-4,
                          phrase("Stimuli", "height of the largest grains"))}},
       make_sandpaper},
  };
}

}  // namespace asperity
