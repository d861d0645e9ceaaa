// The heights recovered from photographs, compared with known heights, for the tables of docs/photographs.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/random.h"
#include "app/study_files/height_field_files.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/measured/normal_map.h"
#include "stimuli/photographs/photograph_advice.h"
#include "stimuli/photographs/synthetic_photograph.h"
#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {
namespace {

constexpr double kLightAzimuth_deg = 30.0;
constexpr double kLightElevation_deg = 40.0;
constexpr double kCameraNoise = 0.005;
constexpr std::size_t kPixels = 512;
constexpr double kWidth_m = 0.05;
constexpr int kResamples = 10000;

/// A photograph of a surface with known heights.
struct Case {
  std::string group{};
  std::string name{};
  GreyImage photograph{};
  HeightField truth;
  double width_m = 0.0;
  bool light_is_known = false;
};

struct Score {
  double correlation = 0.0;
  double spectrum_error_dB = 0.0;
};

double correlation(const std::vector<float>& a, const std::vector<float>& b) {
  const auto mean_of = [](const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
  };
  const double mean_a = mean_of(a);
  const double mean_b = mean_of(b);
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = static_cast<double>(a[i]) - mean_a;
    const double y = static_cast<double>(b[i]) - mean_b;
    ab += x * y;
    aa += x * x;
    bb += y * y;
  }
  return ab / std::sqrt(aa * bb);
}

/// The RMS in octaves of wavelength from λ_g downwards, as proportions of the total RMS.
std::vector<double> octaves(const HeightField& field, double longest_m) {
  std::vector<double> levels{};
  for (double wavelength_m = longest_m; wavelength_m >= 4.0 * field.grid().pitch_m;
       wavelength_m *= 0.5) {
    const HeightField longer = without_long_wavelengths(field, wavelength_m);
    const HeightField shorter = without_long_wavelengths(field, 0.5 * wavelength_m);
    std::vector<float> band = longer.heights_m();
    for (std::size_t i = 0; i < band.size(); ++i) band[i] -= shorter.heights_m()[i];
    levels.push_back(HeightField(field.grid(), std::move(band)).rms_m() / field.rms_m());
  }
  return levels;
}

Score score_of(const HeightField& recovered, const HeightField& truth, double longest_m) {
  Score score{.correlation = correlation(recovered.heights_m(), truth.heights_m())};
  const std::vector<double> found = octaves(recovered, longest_m);
  const std::vector<double> wanted = octaves(truth, longest_m);
  double squares = 0.0;
  int counted = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (wanted[k] < 0.01) continue;  // 40 dB below the total
    const double error_dB = 20.0 * std::log10(std::max(found[k], 1e-6) / wanted[k]);
    squares += error_dB * error_dB;
    ++counted;
  }
  score.spectrum_error_dB = counted > 0 ? std::sqrt(squares / counted) : 0.0;
  return score;
}

/// A way from a photograph to heights.
struct Way {
  std::string name{};
  std::function<TextureRecipe(const Case&)> recipe{};
  bool needs_light = false;
};

TextureRecipe recipe_of(const Case& of, const std::string& method, double tilt) {
  TextureRecipe recipe{};
  recipe.width_m = of.width_m;
  recipe.method = method;
  recipe.spectral_tilt = tilt;
  recipe.light_azimuth_deg = kLightAzimuth_deg;
  recipe.light_elevation_deg = kLightElevation_deg;
  return recipe;
}

/// As photograph_advice.h recommends, for a user who knows whether the light came from one side.
TextureRecipe recommended(const Case& of) {
  const TextureRecipe defaults = recipe_of(of, kPublishedMethod, 0.0);
  const MethodRecommendation advised =
      recommended_method(examine_photograph(of.photograph, defaults, of.name));
  const bool is_shading = advised.method == kShadingMethod && of.light_is_known;
  return is_shading ? recipe_of(of, kShadingMethod, 0.0)
                    : recipe_of(of, kBrightnessMethod, kRecommendedTilt);
}

std::vector<Way> ways(bool with_tilts) {
  const auto fixed_way = [](const char* name, const char* method, double tilt, bool needs_light) {
    return Way{name, [method, tilt](const Case& of) { return recipe_of(of, method, tilt); },
               needs_light};
  };
  std::vector<Way> all{fixed_way("plain", kBrightnessMethod, 0.0, false),
                       {"recommended", recommended},
                       fixed_way("tilted", kBrightnessMethod, kRecommendedTilt, false),
                       fixed_way("wu", kPublishedMethod, 0.0, false),
                       fixed_way("pentland", kShadingMethod, 0.0, true),
                       fixed_way("tsai_shah", "tsai_shah", 0.0, true)};
  if (with_tilts) {
    all.push_back(fixed_way("tilt 0.25", kBrightnessMethod, 0.25, false));
    all.push_back(fixed_way("tilt 0.75", kBrightnessMethod, 0.75, false));
    all.push_back(fixed_way("tilt 1", kBrightnessMethod, 1.0, false));
  }
  return all;
}

void add_rendered(std::vector<Case>& cases, const std::string& name, const HeightField& relief) {
  for (const auto& [group, photograph_case] :
       {std::pair{"rendered, bright = high", PhotographCase::bright_height},
        std::pair{"rendered, light from one side", PhotographCase::lambert},
        std::pair{"rendered, paint", PhotographCase::albedo}}) {
    PhotographSettings settings{
        .photograph_case = photograph_case,
        .light_azimuth_rad = kLightAzimuth_deg * std::numbers::pi / 180.0,
        .light_elevation_rad = kLightElevation_deg * std::numbers::pi / 180.0,
        .noise_rms = kCameraNoise};
    cases.push_back({group, name, synthetic_photograph(relief, settings), relief, relief.width_m(),
                     photograph_case == PhotographCase::lambert});
  }
}

HeightField field_of(const GreyImage& heights, double width_m, double range_m) {
  std::vector<float> heights_m = heights.values;
  for (float& height_m : heights_m) height_m *= static_cast<float>(range_m);
  return {{heights.rows, heights.columns, width_m / static_cast<double>(heights.columns)},
          std::move(heights_m)};
}

void print_gain(const std::vector<double>& gains, const std::string& way) {
  double sum = 0.0;
  for (const double gain : gains) sum += gain;
  Random random(1);
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    double total = 0.0;
    for (std::size_t i = 0; i < gains.size(); ++i) {
      total += gains[std::min(
          gains.size() - 1,
          static_cast<std::size_t>(random.uniform() * static_cast<double>(gains.size())))];
    }
    mean = total / static_cast<double>(gains.size());
  }
  std::sort(means.begin(), means.end());
  std::printf("  %-12s mean gain in |r| over plain %+.3f, 95 %% CI [%+.3f, %+.3f], N = %zu\n",
              way.c_str(), sum / static_cast<double>(gains.size()), means[kResamples / 40],
              means[kResamples - 1 - kResamples / 40], gains.size());
}

void print_scores(const std::vector<Case>& cases, bool with_tilts) {
  std::vector<std::string> groups{};
  for (const Case& each : cases) {
    if (std::find(groups.begin(), groups.end(), each.group) == groups.end()) {
      groups.push_back(each.group);
    }
  }
  const std::vector<Way> all = ways(with_tilts);
  for (const std::string& group : groups) {
    std::printf("%s: correlation in the passband (RMS error of the octave spectrum in dB)\n",
                group.c_str());
    std::printf("  %-14s", "relief");
    for (const Way& way : all) std::printf(" %-14s", way.name.c_str());
    std::printf(" skewness anisotropy direction\n");
    std::vector<std::vector<double>> gains(all.size());
    for (const Case& each : cases) {
      if (each.group != group) continue;
      std::printf("  %-14s", each.name.c_str());
      const double longest_m = TextureRecipe{}.gaussian_wavelength_m;
      const HeightField truth = without_long_wavelengths(each.truth, longest_m);
      double plain = 0.0;
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k].needs_light && !each.light_is_known) {
          std::printf(" %-14s", "-");
          continue;
        }
        const TextureRecipe recipe = all[k].recipe(each);
        const HeightField found = texture_from_photograph(each.photograph, recipe, each.name).field;
        const Score score = score_of(found, truth, longest_m);
        if (k == 0) plain = std::abs(score.correlation);
        gains[k].push_back(std::abs(score.correlation) - plain);
        std::printf(" %+.3f (%4.1f)  ", score.correlation, score.spectrum_error_dB);
      }
      const PhotographEvidence evidence =
          examine_photograph(each.photograph, recipe_of(each, kPublishedMethod, 0.0), each.name);
      std::printf(" %+.2f %.2f %.0f°\n", evidence.skewness, evidence.anisotropy,
                  evidence.direction_rad * 180.0 / std::numbers::pi);
      std::fflush(stdout);
    }
    for (std::size_t k = 1; k < all.size(); ++k) {
      if (!gains[k].empty()) print_gain(gains[k], all[k].name);
    }
  }
}

int usage() {
  std::fputs(
      "bench_photograph_reliefs [--no-synthetic] [--tilts]\n"
      "    [--photograph NAME PHOTO HEIGHTS WIDTH_M]   a photograph and known heights\n"
      "    [--normals NAME PHOTO NORMALS WIDTH_M]      ... and a normal map (OpenGL)\n"
      "    [--heights NAME HEIGHTS WIDTH_M RANGE_M]    known heights, rendered\n",
      stderr);
  return 2;
}

int run(const std::vector<std::string>& words) {
  std::vector<Case> cases{};
  bool is_synthetic = true;
  bool with_tilts = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--no-synthetic") {
      is_synthetic = false;
    } else if (words[i] == "--tilts") {
      with_tilts = true;
    } else if (i + 4 < words.size() && words[i] == "--photograph") {
      const double width_m = std::stod(words[i + 4]);
      cases.push_back({"photographs", words[i + 1], load_photograph(words[i + 2]).photograph.grey,
                       field_of(load_photograph(words[i + 3]).photograph.grey, width_m, 1e-3),
                       width_m});
      i += 4;
    } else if (i + 4 < words.size() && words[i] == "--normals") {
      const double width_m = std::stod(words[i + 4]);
      const GreyImage heights = integrated_slopes(
          slopes_of_normal_map(load_color_picture(words[i + 3]), NormalConvention::opengl));
      cases.push_back({"photographs", words[i + 1], load_photograph(words[i + 2]).photograph.grey,
                       field_of(heights, width_m, 1e-4), width_m});
      i += 4;
    } else if (i + 4 < words.size() && words[i] == "--heights") {
      add_rendered(cases, words[i + 1],
                   field_of(load_photograph(words[i + 2]).photograph.grey, std::stod(words[i + 3]),
                            std::stod(words[i + 4])));
      i += 4;
    } else {
      return usage();
    }
  }
  if (is_synthetic) {
    for (const SurfaceDeclaration& surface : synthetic_surfaces()) {
      add_rendered(
          cases, surface.kind,
          make_surface(surface.kind, {}, {.width_m = kWidth_m, .pixels = kPixels, .seed = 1}));
    }
  }
  print_scores(cases, with_tilts);
  return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  try {
    return asperity::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_photograph_reliefs: %s\n", error.what());
    return 1;
  }
}
