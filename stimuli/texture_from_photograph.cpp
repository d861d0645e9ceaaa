// The chapter's pipeline, step by step.

#include "stimuli/texture_from_photograph.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <opencv2/core.hpp>

#include "analysis/number_text.h"
#include "stimuli/picture_filter.h"

namespace asperity {

namespace {

constexpr std::size_t kSmallestSide = 16;  // below, there is nothing between pixel and picture
constexpr double kBlack = 1.0 / 255.0;     // ε: one step of an 8-bit picture
// RMS of f − g below which a picture is flat; one 8-bit step in one pixel of a hundred is 4e-4.
constexpr double kNoContrast = 1e-5;

cv::Mat as_mat(const GreyImage& image) {
  return cv::Mat(static_cast<int>(image.rows), static_cast<int>(image.columns), CV_32FC1,
                 const_cast<float*>(image.values.data()));
}

GreyImage as_image(const cv::Mat& mat) {
  GreyImage image{static_cast<std::size_t>(mat.rows), static_cast<std::size_t>(mat.cols), {}};
  image.values.assign(mat.ptr<float>(0), mat.ptr<float>(0) + mat.total());
  return image;
}

void refuse_unless_positive(double value, const char* field) {
  if (!std::isfinite(value) || value <= 0.0) {
    throw std::invalid_argument(std::string(field) + " is " + number_text(value) +
                                "; it must be a positive number.");
  }
}

void check(const GreyImage& photograph, const TextureRecipe& recipe, const std::string& name) {
  refuse_unless_positive(recipe.width_m, "width_m");
  refuse_unless_positive(recipe.homomorphic_wavelength_m, "homomorphic_wavelength_m");
  refuse_unless_positive(recipe.gamma_low, "gamma_low");
  refuse_unless_positive(recipe.gamma_high, "gamma_high");
  refuse_unless_positive(recipe.gaussian_wavelength_m, "gaussian_wavelength_m");
  refuse_unless_positive(recipe.rms_m, "rms_m");
  if (photograph.rows < kSmallestSide || photograph.columns < kSmallestSide ||
      photograph.values.size() != photograph.rows * photograph.columns) {
    throw std::invalid_argument(name + " is " + std::to_string(photograph.columns) + " by " +
                                std::to_string(photograph.rows) +
                                " pixels; a texture needs at least 16 by 16.");
  }
  const double pitch_m = recipe.width_m / static_cast<double>(photograph.columns);
  for (const auto& [wavelength_m, field] :
       {std::pair{recipe.homomorphic_wavelength_m, "homomorphic_wavelength_m"},
        std::pair{recipe.gaussian_wavelength_m, "gaussian_wavelength_m"}}) {
    if (wavelength_m < 2.0 * pitch_m) {
      throw std::invalid_argument(std::string(field) + " is " + number_text(wavelength_m) +
                                  " m; over " + number_text(recipe.width_m) + " m " + name +
                                  " shows nothing shorter than two pixels, " +
                                  number_text(2.0 * pitch_m) + " m.");
    }
  }
}

/// Brightness replaced by the share of pixels that are darker, ties in the middle of their share.
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

cv::Mat evened_light(const cv::Mat& brightness, const TextureRecipe& recipe, double pitch_m) {
  cv::Mat work;
  brightness.convertTo(work, CV_32F, 1.0, kBlack);
  cv::log(work, work);
  // γ_L + (γ_H − γ_L)(1 − exp(−ν² λ²)) in the shape of RadialFilter: exp(−½ ν² (√2 λ)²).
  work = filtered(
      work, {.constant = recipe.gamma_high,
             .gaussian = recipe.gamma_low - recipe.gamma_high,
             .cutoff_wavelength = std::numbers::sqrt2 * recipe.homomorphic_wavelength_m / pitch_m});
  cv::exp(work, work);
  work -= kBlack;
  return work;
}

cv::Mat low_passed(const cv::Mat& picture, double wavelength_m, double pitch_m) {
  return filtered(picture, {.cutoff_wavelength = wavelength_m / pitch_m});
}

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

/// Refuses a residual that is nothing but rounding.
Spread spread_of(const cv::Mat& residual, const TextureRecipe& recipe, const std::string& name) {
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(residual, mean, deviation);
  if (!(deviation[0] > kNoContrast)) {  // NaN, of a picture that holds one, ends here too
    throw std::invalid_argument(
        name + " has no contrast at wavelengths that could be felt (shorter than about " +
        number_text(2.0 * recipe.gaussian_wavelength_m) +
        " m); a texture needs a picture that shows one.");
  }
  return {.mean = mean[0], .deviation = deviation[0]};
}

}  // namespace

ParameterValues parameter_values(const TextureRecipe& recipe) {
  return {
      {"width_m", recipe.width_m},
      {"histogram",
       std::string(recipe.histogram == HistogramTransformation::none ? "none" : "equalize")},
      {"homomorphic_wavelength_m", recipe.homomorphic_wavelength_m},
      {"gamma_low", recipe.gamma_low},
      {"gamma_high", recipe.gamma_high},
      {"gaussian_wavelength_m", recipe.gaussian_wavelength_m},
      {"rms_m", recipe.rms_m},
      {"sign", recipe.sign == HeightSign::bright_is_high ? 1.0 : -1.0},
  };
}

std::vector<Parameter> texture_recipe_parameters() {
  const TextureRecipe usual{};
  const auto number = [](const char* name, const char* unit, double minimum, double maximum,
                         double usual_value, const char* meaning) {
    return Parameter{.name = name,
                     .kind = ParameterKind::number,
                     .unit = unit,
                     .minimum = minimum,
                     .maximum = maximum,
                     .choices = {},
                     .default_value = usual_value,
                     .meaning = meaning};
  };
  return {
      number("width_m", "m", 0.001, 1.0, usual.width_m,
             "What the photograph shows on the surface, from its left to its right edge"),
      {.name = "histogram",
       .kind = ParameterKind::choice,
       .unit = "1",
       .choices = {"none", "equalize"},
       .default_value = std::string("none"),
       .meaning = "none: brightness as stored; equalize: every brightness is made equally "
                  "frequent, which tears brightness from height"},
      number("homomorphic_wavelength_m", "m", 0.0005, 0.5, usual.homomorphic_wavelength_m,
             "Changes of brightness that are longer than this count as lighting, shorter ones as "
             "the surface"),
      number("gamma_low", "1", 0.05, 2.0, usual.gamma_low,
             "What slow changes of the lighting are multiplied by; below 1 evens them out"),
      number("gamma_high", "1", 0.2, 5.0, usual.gamma_high,
             "What fine detail is multiplied by; above 1 raises its contrast"),
      number("gaussian_wavelength_m", "m", 0.0002, 0.2, usual.gaussian_wavelength_m,
             "Waves longer than about this are left out of the heights: they are shape, not "
             "texture"),
      number("rms_m", "m", 1e-6, 2e-3, usual.rms_m,
             "How rough the relief is: the root mean square of its heights. A photograph cannot "
             "tell it"),
  };
}

TextureRecipe texture_recipe(const ParameterValues& values) {
  ParameterValues complete = parameter_values(TextureRecipe{});
  for (const auto& [name, value] : values) complete[name] = value;
  const std::string& histogram = choice_of(complete, "histogram");
  if (histogram != "none" && histogram != "equalize") {
    throw std::invalid_argument("histogram is \"" + histogram + "\"; it must be none or equalize.");
  }
  return {.width_m = number_of(complete, "width_m"),
          .histogram = histogram == "none" ? HistogramTransformation::none
                                           : HistogramTransformation::equalize,
          .homomorphic_wavelength_m = number_of(complete, "homomorphic_wavelength_m"),
          .gamma_low = number_of(complete, "gamma_low"),
          .gamma_high = number_of(complete, "gamma_high"),
          .gaussian_wavelength_m = number_of(complete, "gaussian_wavelength_m"),
          .rms_m = number_of(complete, "rms_m"),
          .sign = number_of(complete, "sign") > 0.0 ? HeightSign::bright_is_high
                                                    : HeightSign::dark_is_high};
}

PhotographTexture texture_from_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                          const std::string& name) {
  check(photograph, recipe, name);
  const double pitch_m = recipe.width_m / static_cast<double>(photograph.columns);
  GreyImage grey =
      recipe.histogram == HistogramTransformation::equalize ? equalized(photograph) : photograph;
  const cv::Mat evened = evened_light(as_mat(grey), recipe, pitch_m);
  const cv::Mat low_pass = low_passed(evened, recipe.gaussian_wavelength_m, pitch_m);

  cv::Mat residual = evened - low_pass;
  const Spread spread = spread_of(residual, recipe, name);
  const double sign = recipe.sign == HeightSign::bright_is_high ? 1.0 : -1.0;
  const double scale_m = sign * recipe.rms_m / spread.deviation;
  residual.convertTo(residual, CV_32F, scale_m, -spread.mean * scale_m);

  HeightField field(
      {.rows = photograph.rows, .columns = photograph.columns, .pitch_m = pitch_m},
      std::vector<float>(residual.ptr<float>(0), residual.ptr<float>(0) + residual.total()));
  return {std::move(field), std::move(grey), as_image(evened), as_image(low_pass)};
}

GreyImage brightness_residual(const GreyImage& photograph, const TextureRecipe& recipe,
                              const std::string& name) {
  check(photograph, recipe, name);
  const double pitch_m = recipe.width_m / static_cast<double>(photograph.columns);
  const cv::Mat brightness = as_mat(photograph);
  const cv::Mat residual =
      brightness - low_passed(brightness, recipe.gaussian_wavelength_m, pitch_m);
  spread_of(residual, recipe, name);
  return as_image(residual);
}

HeightField without_long_wavelengths(const HeightField& field, double gaussian_wavelength_m) {
  refuse_unless_positive(gaussian_wavelength_m, "gaussian_wavelength_m");
  const HeightField::Grid& grid = field.grid();
  const cv::Mat heights_m(static_cast<int>(grid.rows), static_cast<int>(grid.columns), CV_32FC1,
                          const_cast<float*>(field.heights_m().data()));
  const cv::Mat rest_m = heights_m - low_passed(heights_m, gaussian_wavelength_m, grid.pitch_m);
  return {grid, std::vector<float>(rest_m.ptr<float>(0), rest_m.ptr<float>(0) + rest_m.total())};
}

}  // namespace asperity
