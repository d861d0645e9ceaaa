// Implements the steps of the pipeline as functions of the previous results.

#include "stimuli/photographs/texture_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "stimuli/photographs/texture_method.h"
#include "stimuli/pictures/bands.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

namespace {

// The shortest wave in a photograph is two pixels long. A tip of the usual 2 mm follows no wave shorter than its own
// size: a picture whose pixels are larger than 1 mm of the surface contains shape but no texture for a probe.
constexpr double kLargestPitch_m = 1e-3;
constexpr std::size_t kSmallestSide = 16;  // with fewer, no band lies between pixel and picture
// RMS of f − g below which a picture has no contrast; one 8-bit step in 1 % of the pixels is 4e-4.
constexpr double kNoContrast = 1e-5;

cv::Mat mat_over(const GreyImage& image) {
  return cv::Mat(static_cast<int>(image.rows), static_cast<int>(image.columns), CV_32FC1,
                 const_cast<float*>(image.values.data()));
}

/// Calls use(band) for pieces of the picture, each a matrix of one row. The pieces begin at steps of OpenCV's vector
/// loops, so that the same loop processes each pixel for any number of pieces.
template <class Use>
void in_pieces(GreyImage& image, int threads, const Use& use) {
  constexpr std::size_t kStep = 64;
  const std::size_t count = image.values.size();
  in_bands((count + kStep - 1) / kStep, threads, [&](std::size_t first, std::size_t last) {
    const std::size_t begin = first * kStep;
    const std::size_t end = std::min(last * kStep, count);
    use(cv::Mat(1, static_cast<int>(end - begin), CV_32FC1, image.values.data() + begin));
  });
}

/// Replaces brightness by the proportion of darker pixels plus half of the proportion of equal ones.
GreyImage equalized(const GreyImage& image) {
  constexpr std::size_t kLevels = 65536;
  const auto level_of = [](float value) {
    return static_cast<std::size_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * (kLevels - 1)));
  };
  std::vector<double> share(kLevels, 0.0);
  for (const float value : image.values) share[level_of(value)] += 1.0;
  double darker = 0.0;
  for (double& count : share) {
    const double here = count;
    count = (darker + 0.5 * here) / static_cast<double>(image.values.size());
    darker += here;
  }
  GreyImage result = image;
  for (float& value : result.values) value = static_cast<float>(share[level_of(value)]);
  return result;
}

/// Rejects a width outside the range of explored surfaces, and pixels too large for texture.
void check_width(const GreyImage& photograph, double width_m, const std::string& name) {
  refuse_unless_positive(width_m, "width_m");
  const std::vector<Parameter> declared = texture_recipe_parameters();
  const auto width = std::find_if(declared.begin(), declared.end(), [](const Parameter& parameter) {
    return parameter.name == "width_m";
  });
  if (const auto complaint = complaint_about(*width, width_m)) {
    const std::string given = number_text(width_m);
    throw PhrasedRefusal(phrase("Stimuli",
                                "%1 It is the width of the surface in %2, from its left to its "
                                "right edge: %3 cm are %4 m.")
                             .with(*complaint, name, given, number_text(width_m * 1e-2)));
  }
  const double pitch_m = width_m / static_cast<double>(photograph.columns);
  if (pitch_m > kLargestPitch_m) {
    throw PhrasedRefusal(
        phrase(
            "Stimuli",
            "width_m is %1 m: each of the %2 pixels of %3 would be %4 mm of the surface, and "
            "pixels larger than %5 mm cannot represent a texture. Take a photograph of a smaller "
            "part of the surface, or one with more pixels.")
            .with(number_text(width_m), std::to_string(photograph.columns), name,
                  number_text(pitch_m * 1e3), number_text(kLargestPitch_m * 1e3)));
  }
}

}  // namespace

void refuse_unless_positive(double value, const char* field) {
  if (!std::isfinite(value) || value <= 0.0) {
    throw std::invalid_argument(std::string(field) + " is " + number_text(value) +
                                "; it must be a positive number.");
  }
}

void check_recipe(const GreyImage& photograph, const TextureRecipe& recipe,
                  const std::string& name) {
  refuse_unless_positive(recipe.homomorphic_wavelength_m, "homomorphic_wavelength_m");
  refuse_unless_positive(recipe.gamma_low, "gamma_low");
  refuse_unless_positive(recipe.gamma_high, "gamma_high");
  refuse_unless_positive(recipe.gaussian_wavelength_m, "gaussian_wavelength_m");
  refuse_unless_positive(recipe.rms_m, "rms_m");
  if (!(recipe.spectral_tilt >= 0.0 && recipe.spectral_tilt <= kLargestTilt)) {
    throw std::invalid_argument("spectral_tilt is " + number_text(recipe.spectral_tilt) +
                                "; it must be a number from 0 to " + number_text(kLargestTilt) +
                                '.');
  }
  check_method(recipe);
  if (photograph.rows < kSmallestSide || photograph.columns < kSmallestSide ||
      photograph.values.size() != photograph.rows * photograph.columns) {
    throw PhrasedRefusal(
        phrase("Stimuli",
               "%1 is %2 by %3 pixels; a texture needs at least 16 by 16. Use a photograph with "
               "more pixels.")
            .with(name, std::to_string(photograph.columns), std::to_string(photograph.rows)));
  }
  check_width(photograph, recipe.width_m, name);
  const double pitch_m = recipe.width_m / static_cast<double>(photograph.columns);
  for (const auto& [wavelength_m, field] :
       {std::pair{recipe.homomorphic_wavelength_m, "homomorphic_wavelength_m"},
        std::pair{recipe.gaussian_wavelength_m, "gaussian_wavelength_m"}}) {
    if (wavelength_m < 2.0 * pitch_m) {
      throw PhrasedRefusal(
          phrase("Stimuli",
                 "%1 is %2 m; %3, %4 m wide, cannot represent wavelengths shorter than two pixels, "
                 "%5 m. Choose a longer wavelength.")
              .with(field, number_text(wavelength_m), name, number_text(recipe.width_m),
                    number_text(2.0 * pitch_m)));
    }
  }
}

GreyImage with_histogram(const GreyImage& photograph, HistogramTransformation transformation) {
  return transformation == HistogramTransformation::equalize ? equalized(photograph) : photograph;
}

double homomorphic_cutoff(const TextureRecipe& recipe, const GreyImage& photograph) noexcept {
  // γ_L + (γ_H − γ_L)(1 − exp(−ν² λ²)) in the shape of RadialFilter: exp(−½ ν² (√2 λ)²).
  const double pitch_m = recipe.width_m / static_cast<double>(photograph.columns);
  return std::numbers::sqrt2 * recipe.homomorphic_wavelength_m / pitch_m;
}

double gaussian_cutoff(const TextureRecipe& recipe, const GreyImage& photograph) noexcept {
  const double pitch_m = recipe.width_m / static_cast<double>(photograph.columns);
  return recipe.gaussian_wavelength_m / pitch_m;
}

PictureSpectrum logarithm_spectrum(const GreyImage& grey, double homomorphic_cutoff, int threads) {
  GreyImage logarithm = grey;
  in_pieces(logarithm, threads, [](cv::Mat piece) {
    piece += kBlackLevel;
    cv::log(piece, piece);
  });
  return {logarithm, homomorphic_cutoff, threads};
}

GreyImage evened_light(const PictureSpectrum& logarithm, const TextureRecipe& recipe, int threads) {
  GreyImage evened = logarithm.filtered(
      {.constant = recipe.gamma_high, .gaussian = recipe.gamma_low - recipe.gamma_high});
  in_pieces(evened, threads, [](cv::Mat piece) {
    cv::exp(piece, piece);
    piece -= kBlackLevel;
  });
  return evened;
}

GreyImage low_passed(const GreyImage& picture, double gaussian_cutoff, int threads) {
  return PictureSpectrum(picture, gaussian_cutoff, threads).filtered({});
}

GreyImage difference(const GreyImage& from, const GreyImage& what) {
  GreyImage result = from;
  for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] -= what.values[i];
  return result;
}

Residual residual_of(const GreyImage& evened, const GreyImage& low_pass,
                     const TextureRecipe& recipe, const std::string& name, int threads) {
  Residual residual{.values = difference(evened, low_pass)};
  if (recipe.spectral_tilt != 0.0) {
    residual.values =
        PictureSpectrum(residual.values, gaussian_cutoff(recipe, evened), threads)
            .filtered({.constant = 1.0, .gaussian = 0.0, .tilt = recipe.spectral_tilt});
  }
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(mat_over(residual.values), mean, deviation);
  if (!(deviation[0] > kNoContrast)) {  // NaN, of a picture that contains one, ends here too
    throw PhrasedRefusal(
        phrase(
            "Stimuli",
            "%1 has no contrast at wavelengths that could be felt (shorter than about %2 m); use "
            "a photograph in which the texture is visible.")
            .with(name, number_text(2.0 * recipe.gaussian_wavelength_m)));
  }
  residual.mean = mean[0];
  residual.deviation = deviation[0];
  return residual;
}

HeightField heights_of(Residual residual, const TextureRecipe& recipe) {
  const double sign = recipe.sign == HeightSign::bright_is_high ? 1.0 : -1.0;
  const double scale_m = sign * recipe.rms_m / residual.deviation;
  cv::Mat heights_m = mat_over(residual.values);
  heights_m.convertTo(heights_m, CV_32F, scale_m, -residual.mean * scale_m);
  return {{.rows = residual.values.rows,
           .columns = residual.values.columns,
           .pitch_m = recipe.width_m / static_cast<double>(residual.values.columns)},
          std::move(residual.values.values)};
}

}  // namespace asperity
