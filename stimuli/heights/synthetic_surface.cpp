// Collects the makers, and warns of seams and coarse samples of regular structures.

#include "stimuli/heights/synthetic_surface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "stimuli/heights/surface_makers.h"

namespace asperity {
namespace {

std::vector<SurfaceMaker> all_makers() {
  std::vector<SurfaceMaker> makers = pattern_makers();
  for (SurfaceMaker& maker : material_makers()) makers.push_back(std::move(maker));
  return makers;
}

constexpr double kFewestSamples = 8.0;  // of a wave
constexpr double kNarrowest_m = 1e-3;
constexpr double kWidest_m = 1.0;
constexpr std::size_t kFewestPixels = 16;
constexpr std::size_t kMostPixels = 8192;
constexpr double kWholeWaves = 1e-3;  // of a wave: a smaller seam is rounding

// Rounded to nanometres, without the last bits of a division; in metres.
std::string length_text(double length_m) {
  constexpr double kNanometres_per_m = 1e9;
  return number_text(std::round(length_m * kNanometres_per_m) / kNanometres_per_m);
}

// A structure that repeats along an axis of the canvas.
struct RegularRepeat {
  RegularPart part = RegularPart::spacing;
  double length_m = 0.0;
  char axis = 'x';
};

// "spacings of 0.002 m (spacing_m)"
Phrase text_of_parts(RegularPart part, double length_m) {
  const std::string length = length_text(length_m);
  switch (part) {
    case RegularPart::spacing:
      break;
    case RegularPart::spacing_at_angle:
      return phrase("Stimuli", "spacings of %1 m (spacing_m at this angle_rad)").with(length);
    case RegularPart::brick:
      return phrase("Stimuli", "bricks of %1 m (brick_length_m)").with(length);
    case RegularPart::pair_of_courses:
      return phrase("Stimuli", "pairs of courses of %1 m (2 · course_height_m)").with(length);
  }
  return phrase("Stimuli", "spacings of %1 m (spacing_m)").with(length);
}

// The complete values of a kind; empty if `make_surface` would refuse them.
std::optional<ParameterValues> values_of_kind(std::string_view kind,
                                              const ParameterValues& values) {
  for (const SurfaceMaker& maker : all_makers()) {
    if (maker.declaration.kind != kind) continue;
    try {
      return complete_values(maker.declaration.kind, maker.declaration.parameters, values);
    } catch (const std::invalid_argument&) {
      return {};
    }
  }
  return {};
}

std::vector<RegularRepeat> repeats_of(std::string_view kind, const ParameterValues& values) {
  const auto spacings = [&values](char axis, double part = 1.0) {
    return RegularRepeat{part == 1.0 ? RegularPart::spacing : RegularPart::spacing_at_angle,
                         number_of(values, "spacing_m") / part, axis};
  };
  if (kind == "cones" && number_of(values, "angle_rad") == 0.0) {
    return {spacings('x'), spacings('y')};
  }
  if (kind == "sinusoid" || kind == "cones") {
    std::vector<RegularRepeat> repeats{};
    const double angle_rad = number_of(values, "angle_rad");
    for (const auto& [axis, part] : {std::pair{'x', std::abs(std::cos(angle_rad))},
                                     std::pair{'y', std::abs(std::sin(angle_rad))}}) {
      if (part > kWholeWaves) repeats.push_back(spacings(axis, part));
    }
    return repeats;
  }
  if (kind == "grating" || kind == "wood") return {spacings('x')};
  if (kind == "brick") {
    return {{RegularPart::brick, number_of(values, "brick_length_m"), 'x'},
            {RegularPart::pair_of_courses, 2.0 * number_of(values, "course_height_m"), 'y'}};
  }
  return {};
}

}  // namespace

std::optional<SurfaceSeam> seam_of(std::string_view kind, const ParameterValues& values,
                                   const SurfaceCanvas& canvas) {
  const std::optional<ParameterValues> complete = values_of_kind(kind, values);
  if (!complete) return {};
  for (const RegularRepeat& repeat : repeats_of(kind, *complete)) {
    const double count = canvas.width_m / repeat.length_m;
    if (std::abs(count - std::round(count)) <= kWholeWaves) continue;
    SurfaceSeam seam{.width_m = canvas.width_m,
                     .axis = repeat.axis,
                     .part = repeat.part,
                     .part_m = repeat.length_m,
                     .count = count,
                     .wider_m = std::ceil(count) * repeat.length_m};
    if (count > 1.0) seam.narrower_m = std::floor(count) * repeat.length_m;
    return seam;
  }
  return {};
}

Phrase text_of(const SurfaceSeam& seam) {
  constexpr double kHundredth = 100.0;
  const std::string wider = length_text(seam.wider_m);
  const Phrase widths =
      seam.narrower_m ? phrase("Stimuli", "%1 m or %2 m").with(length_text(*seam.narrower_m), wider)
                      : Phrase("%1 m").with(wider);
  return phrase(
             "Stimuli",
             "%1 m along %2 contain %3 %4, and the last one is cut where the surface is "
             "repeated: this makes an unintended step; choose a width of %5, which contains only "
             "complete ones")
      .with(length_text(seam.width_m), std::string(1, seam.axis),
            number_text(std::round(seam.count * kHundredth) / kHundredth),
            text_of_parts(seam.part, seam.part_m), widths);
}

std::optional<CoarseSamples> coarse_samples_of(std::string_view kind, const ParameterValues& values,
                                               const SurfaceCanvas& canvas) {
  const std::optional<ParameterValues> complete = values_of_kind(kind, values);
  if (!complete || repeats_of(kind, *complete).empty() || !complete->contains("spacing_m")) {
    return {};
  }
  const double spacing_m = number_of(*complete, "spacing_m");
  const double samples = spacing_m / pitch_of(canvas);
  constexpr double kRounding = 1e-6;
  if (samples >= kFewestSamples * (1.0 - kRounding)) return {};
  return CoarseSamples{
      .spacing_m = spacing_m,
      .pitch_m = pitch_of(canvas),
      .samples = samples,
      .pixels = std::ceil(kFewestSamples * canvas.width_m / spacing_m - kRounding)};
}

Phrase text_of(const CoarseSamples& coarse) {
  constexpr double kTenth = 10.0;
  return phrase(
             "Stimuli",
             "spacing_m is %1 m, and the samples are %2 m apart: %3 per spacing, so that heights "
             "and shape differ from those requested; choose %4 or more samples per side, which "
             "gives eight per spacing")
      .with(length_text(coarse.spacing_m), length_text(coarse.pitch_m),
            number_text(std::round(coarse.samples * kTenth) / kTenth), number_text(coarse.pixels));
}

std::vector<SurfaceDeclaration> synthetic_surfaces() {
  std::vector<SurfaceDeclaration> declarations;
  for (SurfaceMaker& maker : all_makers()) declarations.push_back(std::move(maker.declaration));
  return declarations;
}

std::vector<Parameter> canvas_parameters() {
  constexpr double kGreatestSeed = 9007199254740991.0;  // the whole numbers of a double
  const SurfaceCanvas usual{};
  return {number_parameter("width_m", "m", kNarrowest_m, kWidest_m, usual.width_m,
                           phrase("Stimuli", "Side of the square")),
          integer_parameter("pixels", kFewestPixels, kMostPixels, static_cast<double>(usual.pixels),
                            phrase("Stimuli", "Samples per side")),
          integer_parameter("seed", 0.0, kGreatestSeed, static_cast<double>(usual.seed),
                            phrase("Stimuli", "Seed of all random numbers"))};
}

SurfaceCanvas canvas_with(const ParameterValues& values) {
  const ParameterValues complete = complete_values("the canvas", canvas_parameters(), values);
  return {.width_m = number_of(complete, "width_m"),
          .pixels = static_cast<std::size_t>(number_of(complete, "pixels")),
          .seed = static_cast<std::uint64_t>(number_of(complete, "seed"))};
}

HeightField make_surface(std::string_view kind, const ParameterValues& values,
                         const SurfaceCanvas& canvas) {
  if (!(canvas.width_m >= kNarrowest_m && canvas.width_m <= kWidest_m)) {
    throw std::invalid_argument("width_m is " + number_text(canvas.width_m) +
                                " m; it must be from 0.001 to 1 m.");
  }
  if (canvas.pixels < kFewestPixels || canvas.pixels > kMostPixels) {
    throw std::invalid_argument("pixels is " + std::to_string(canvas.pixels) +
                                "; it must be from 16 to 8192 per side.");
  }
  const std::vector<SurfaceMaker> makers = all_makers();
  const auto maker = std::find_if(makers.begin(), makers.end(), [&](const SurfaceMaker& candidate) {
    return candidate.declaration.kind == kind;
  });
  if (maker == makers.end()) {
    std::string names;
    for (const SurfaceMaker& known : makers) {
      names += (names.empty() ? "" : ", ") + known.declaration.kind;
    }
    throw std::invalid_argument("There is no synthetic surface \"" + std::string(kind) +
                                "\"; choose one of: " + names + ".");
  }
  const ParameterValues complete =
      complete_values(maker->declaration.kind, maker->declaration.parameters, values);
  return {{.rows = canvas.pixels, .columns = canvas.pixels, .pitch_m = pitch_of(canvas)},
          maker->make(complete, canvas)};
}

}  // namespace asperity
