// Implements the skewness and direction of a photograph's residual and the advice from them.

#include "stimuli/photographs/photograph_advice.h"

#include <cmath>
#include <numbers>

#include "analysis/numbers/number_text.h"
#include "stimuli/photographs/texture_method.h"

namespace asperity {

namespace {

// A Gaussian texture of this size stays well below kSkewed. Oblique light on an isotropic surface gives an anisotropy
// of 0.5; kDirected leaves a margin for noise.
constexpr double kSkewed = 0.35;
constexpr double kDirected = 0.3;

std::string in_hundredths(double number) { return number_text(std::round(100.0 * number) / 100.0); }

Phrase about_direction(const PhotographEvidence& evidence) {
  return phrase("Stimuli",
                "The brightness varies mostly along %1° from +x. Either the surface has a grain at "
                "right angles to this direction, or the light came from one side along this "
                "direction. In the second case the brightness represents slopes towards the light: "
                "use shape from shading, or take the picture again in even light from all sides.")
      .with(number_text(direction_deg(evidence)));
}

/// The correct sign in each case, whichever is set.
Phrase about_skewness(double skewness) {
  if (skewness < -kSkewed) {
    return phrase("Stimuli",
                  "The picture has narrow dark parts on brighter ground. If they are dark because "
                  "they lie low (grooves, pits), bright is high: the correct sign is 1.");
  }
  return phrase("Stimuli",
                "The picture has narrow bright parts on darker ground. If they stand out (grains, "
                "fibres), bright is high: the correct sign is 1; if they lie low (light mortar "
                "between bricks), it is -1.");
}

}  // namespace

PhotographEvidence examine_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                      const std::string& name) {
  const GreyImage residual = brightness_residual(photograph, recipe, name);
  const std::size_t rows = residual.rows;
  const std::size_t columns = residual.columns;
  double sum = 0.0;
  double squares = 0.0;
  for (const float value : residual.values) {
    sum += static_cast<double>(value);
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  const auto count = static_cast<double>(residual.values.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(squares / count - mean * mean);
  double cubes = 0.0;
  for (const float value : residual.values) {
    cubes += std::pow((static_cast<double>(value) - mean) / deviation, 3);
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      // Differences along the diagonals treat both axes equally.
      const float* here = residual.values.data() + i * columns + j;
      const auto falling = static_cast<double>(here[columns + 1] - here[0]);
      const auto rising = static_cast<double>(here[1] - here[columns]);
      const double dx = rising + falling;
      const double dy = rising - falling;
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
    }
  }
  const double trace = xx + yy;
  return {.skewness = cubes / count,
          .anisotropy = trace > 0.0 ? std::hypot(xx - yy, 2.0 * xy) / trace : 0.0,
          .direction_rad = 0.5 * std::atan2(2.0 * xy, xx - yy)};
}

std::vector<PhotographResemblance> resemblances(const PhotographEvidence& evidence) {
  std::vector<PhotographResemblance> found{};
  if (evidence.anisotropy > kDirected) found.push_back(PhotographResemblance::directed);
  if (evidence.skewness < -kSkewed) found.push_back(PhotographResemblance::dark_grooves);
  if (evidence.skewness > kSkewed) found.push_back(PhotographResemblance::bright_spots);
  if (found.empty()) found.push_back(PhotographResemblance::nothing_clear);
  return found;
}

MethodRecommendation recommended_method(PhotographLight light) noexcept {
  switch (light) {
    case PhotographLight::even:
      return {.method = "brightness", .spectral_tilt = kRecommendedTilt};
    case PhotographLight::one_lamp:
      break;
  }
  return {.method = "pentland"};
}

double direction_deg(const PhotographEvidence& evidence) noexcept {
  const double degrees = std::round(evidence.direction_rad * 180.0 / std::numbers::pi);
  return degrees == 0.0 ? 0.0 : degrees;  // no −0
}

double opposite_deg(double direction_deg) noexcept {
  return direction_deg + (direction_deg > 0.0 ? -180.0 : 180.0);
}

std::string recommendation_text(const PhotographEvidence& evidence, const TextureRecipe& recipe) {
  const MethodRecommendation even = recommended_method(PhotographLight::even);
  const MethodRecommendation lamp = recommended_method(PhotographLight::one_lamp);
  const double along_deg = direction_deg(evidence);
  const bool is_set = recipe.method == even.method && recipe.spectral_tilt == even.spectral_tilt;
  const std::string method = std::string("--method ") + even.method + " --spectral-tilt " +
                             number_text(even.spectral_tilt);
  return "Did the light come from one lamp at the side? The picture does not show it. If not, " +
         (is_set ? "the method is the recommended one (" + method + ")"
                 : "recommended: " + method) +
         ", because on nine of ten measured surfaces it was closer to the relief than the plain "
         "brightness. If so, recommended: --method " +
         lamp.method +
         " --light-azimuth-deg A, with A the direction of the lamp; the brightness varies mostly "
         "along " +
         number_text(along_deg) + "° and " + number_text(opposite_deg(along_deg)) + "°.";
}

std::optional<SignContradiction> contradiction_of_sign(const PhotographEvidence& evidence,
                                                       const TextureRecipe& recipe) {
  if (texture_method(recipe.method).uses_light) return std::nullopt;
  const bool bright_is_high = recipe.sign == HeightSign::bright_is_high;
  if (evidence.skewness < -kSkewed && !bright_is_high) {
    return SignContradiction::dark_grooves_raised;
  }
  if (evidence.skewness > kSkewed && bright_is_high) return SignContradiction::bright_spots_raised;
  return std::nullopt;
}

std::string contradiction_text(SignContradiction contradiction,
                               const PhotographEvidence& evidence) {
  const std::string skewness = " (skewness " + in_hundredths(evidence.skewness) + ")";
  switch (contradiction) {
    case SignContradiction::dark_grooves_raised:
      return "sign -1 turns the narrow dark parts of the picture into ridges" + skewness +
             "; such parts are usually grooves or pits. Inspect the surface, and use --sign 1 if "
             "they lie low.";
    case SignContradiction::bright_spots_raised:
      break;
  }
  return "sign 1 turns the narrow bright parts of the picture into ridges" + skewness +
         ". Inspect the surface, and use --sign -1 if they lie low, as light mortar does.";
}

Phrase advice(const PhotographEvidence& evidence) {
  const bool is_directed = evidence.anisotropy > kDirected;
  const bool is_skewed = std::abs(evidence.skewness) > kSkewed;
  Phrase resemblance = phrase("Stimuli",
                              "The picture does not show whether its brightness follows height; "
                              "stains and paint look the same. Compare the relief with the surface "
                              "itself before using it.");
  if (is_directed && is_skewed) {
    resemblance =
        Phrase("%1 %2").with(about_direction(evidence), about_skewness(evidence.skewness));
  } else if (is_directed) {
    resemblance = about_direction(evidence);
  } else if (is_skewed) {
    resemblance = about_skewness(evidence.skewness);
  }
  return phrase(
             "Stimuli",
             "%1 (Skewness %2, anisotropy %3.) One photograph cannot show whether dark areas are "
             "low, shaded or painted: look at the surface.")
      .with(resemblance, in_hundredths(evidence.skewness), in_hundredths(evidence.anisotropy));
}

}  // namespace asperity
