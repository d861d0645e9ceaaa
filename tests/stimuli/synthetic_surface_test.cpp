// Surfaces from formulas: their numbers, their seams, and that the materials differ under a stroke.

#include "stimuli/heights/synthetic_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "analysis/signals/force_features.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kMaterials{"metal", "stone", "wood", "brick", "sandpaper"};
const SurfaceCanvas kSmall{.width_m = 0.05, .pixels = 256, .seed = 1};

std::string surface_refusal(const std::string& kind, const ParameterValues& values,
                            const SurfaceCanvas& canvas) {
  return refusal_of<std::invalid_argument>([&] { make_surface(kind, values, canvas); });
}

TEST(SyntheticSurface, HasTheKindsOfTheCommandLine) {
  std::vector<std::string> kinds;
  for (const SurfaceDeclaration& declaration : synthetic_surfaces()) {
    kinds.push_back(declaration.kind);
    EXPECT_FALSE(declaration.summary.empty());
    for (const Parameter& parameter : declaration.parameters) {
      EXPECT_FALSE(complaint_about(parameter, parameter.default_value));
      EXPECT_TRUE(parameter.meaning.can_be_translated()) << parameter.name;
    }
  }
  EXPECT_THAT(kinds, ::testing::ElementsAre("sinusoid", "grating", "cones", "noise", "metal",
                                            "stone", "wood", "brick", "sandpaper"));
}

TEST(SyntheticSurface, DependsOnItsSeedWhereItIsRandomAndOnNothingElse) {
  for (const SurfaceDeclaration& declaration : synthetic_surfaces()) {
    const bool regular = declaration.kind == "sinusoid" || declaration.kind == "grating";
    SurfaceCanvas other = kSmall;
    other.seed = 2;
    const auto heights_m = make_surface(declaration.kind, {}, kSmall).heights_m();
    EXPECT_EQ(heights_m, make_surface(declaration.kind, {}, kSmall).heights_m());
    EXPECT_EQ(heights_m == make_surface(declaration.kind, {}, other).heights_m(), regular)
        << declaration.kind;
  }
}

// Across the seam neighbours differ no more than they do anywhere else.
TEST(SyntheticSurface, RepeatsWithoutASeam) {
  for (const SurfaceDeclaration& declaration : synthetic_surfaces()) {
    const HeightField field = make_surface(declaration.kind, {}, {.pixels = 512});
    const auto height_m = [&](std::size_t i, std::size_t j) {
      return static_cast<double>(field.heights_m()[i * 512 + j]);
    };
    double inside_m2 = 0.0;
    double across_m2 = 0.0;
    for (std::size_t k = 0; k < 512; ++k) {
      for (std::size_t at = 0; at < 511; ++at) {
        inside_m2 += std::pow(height_m(k, at + 1) - height_m(k, at), 2) +
                     std::pow(height_m(at + 1, k) - height_m(at, k), 2);
      }
      across_m2 += std::pow(height_m(k, 0) - height_m(k, 511), 2) +
                   std::pow(height_m(0, k) - height_m(511, k), 2);
    }
    // A single column of a regular pattern may lie on a flank; a step would be far steeper.
    EXPECT_LT(across_m2, 3.0 * inside_m2 / 511.0) << declaration.kind;
  }
}

std::string seam_said(const std::string& kind, const ParameterValues& values, double width_m) {
  const auto seam = seam_of(kind, values, {.width_m = width_m, .pixels = 400});
  return seam ? text_of(*seam).english() : "closed";
}

TEST(SyntheticSurface, SaysWhereItsSeamShowsAndWhichWidthsHaveNone) {
  EXPECT_EQ(seam_said("sinusoid", {{"spacing_m", 0.0016}}, 0.02),
            "0.02 m along x contain 12.5 spacings of 0.0016 m (spacing_m), and the last one is cut "
            "where the surface is repeated: this makes an unintended step; choose a width "
            "of 0.0192 m or 0.0208 m, which contains only complete ones");
  EXPECT_EQ(seam_said("sinusoid", {{"spacing_m", 0.0016}}, 0.016), "closed");
  EXPECT_EQ(seam_said("sinusoid", {{"spacing_m", 0.0014}}, 0.028), "closed");  // of doubles, nearly
  EXPECT_THAT(seam_said("sinusoid", {{"spacing_m", 0.03}}, 0.02), HasSubstr("of 0.03 m, which"));
  // Across its crests nothing changes, so nothing is cut there.
  EXPECT_THAT(
      seam_said("sinusoid", {{"spacing_m", 0.0016}, {"angle_rad", std::numbers::pi / 2.0}}, 0.02),
      HasSubstr("along y contain 12.5"));
  EXPECT_EQ(
      seam_said("sinusoid", {{"spacing_m", 0.002}, {"angle_rad", std::numbers::pi / 2.0}}, 0.02),
      "closed");
  EXPECT_THAT(seam_said("grating", {{"spacing_m", 0.003}}, 0.02),
              HasSubstr("contain 6.67 spacings"));
  EXPECT_THAT(seam_said("cones", {{"spacing_m", 0.003}}, 0.02), HasSubstr("contain 6.67 spacings"));
  EXPECT_THAT(seam_said("brick", {}, 0.05), HasSubstr("contain 2.5 bricks of 0.02 m"));
  for (const SurfaceDeclaration& declaration : synthetic_surfaces()) {
    EXPECT_EQ(seam_said(declaration.kind, {}, 0.1), "closed") << declaration.kind;
  }
  EXPECT_EQ(seam_said("noise", {}, 0.0123), "closed");
  EXPECT_EQ(seam_said("velvet", {}, 0.0123), "closed");
}

TEST(SyntheticSurface, SaysWhenItsSamplesAreTooFewForItsShape) {
  const auto said = [](double spacing_m, std::size_t pixels) {
    const auto coarse = coarse_samples_of("sinusoid", {{"spacing_m", spacing_m}},
                                          {.width_m = 0.02, .pixels = pixels});
    return coarse ? text_of(*coarse).english() : "enough";
  };
  EXPECT_EQ(said(0.001, 80),
            "spacing_m is 0.001 m, and the samples are 0.00025 m apart: 4 per spacing, so that "
            "heights and shape differ from those requested; choose 160 or more samples per side, "
            "which gives eight per spacing");
  EXPECT_THAT(said(0.0005, 80), HasSubstr(": 2 per spacing"));
  EXPECT_EQ(said(0.001, 160), "enough");
  for (const SurfaceDeclaration& declaration : synthetic_surfaces()) {
    EXPECT_FALSE(coarse_samples_of(declaration.kind, {}, {})) << declaration.kind;
  }
}

// h = A sin(2πx/L): amplitude A, RMS A/√2, steepest slope 2πA/L.
TEST(Sinusoid, IsTheFormula) {
  const HeightField field = make_surface("sinusoid", {{"amplitude_m", 1e-4}, {"spacing_m", 0.005}},
                                         {.width_m = 0.1, .pixels = 1000});
  EXPECT_NEAR(field.maximum_m(), 1e-4, 1e-7);
  EXPECT_NEAR(field.rms_m(), 1e-4 / std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(field.sample(0.0, 0.01, Tiling::repeat).height_m, 0.0, 1e-9);
  EXPECT_NEAR(field.sample(0.0, 0.01, Tiling::repeat).slope_x,
              2.0 * std::numbers::pi * 1e-4 / 0.005, 5e-4);
  EXPECT_NEAR(field.sample(0.00125, 0.0, Tiling::repeat).height_m, 1e-4, 1e-8);
}

TEST(Sinusoid, RunsAlongItsAngle) {
  const HeightField field =
      make_surface("sinusoid", {{"angle_rad", std::numbers::pi / 2.0}}, kSmall);
  EXPECT_NEAR(field.sample(0.013, 0.0005, Tiling::repeat).height_m, 2e-4, 4e-6);
}

TEST(Grating, HasFlatTopsStraightFlanksAndFlatGrooves) {
  const HeightField field = make_surface("grating",
                                         {{"spacing_m", 0.004},
                                          {"height_m", 1e-4},
                                          {"ridge_width_m", 0.001},
                                          {"flank_width_m", 0.001}},
                                         {.width_m = 0.04, .pixels = 800});
  const auto height_m = [&](double x_m) { return field.sample(x_m, 0.0, Tiling::repeat).height_m; };
  EXPECT_NEAR(height_m(0.0004), 1e-4, 1e-9);
  EXPECT_NEAR(height_m(0.0010), 5e-5, 1e-7);
  EXPECT_NEAR(height_m(0.0018), 0.0, 1e-9);
  EXPECT_NEAR(height_m(0.0041), 1e-4, 1e-9);
}

TEST(Cones, StandOnALatticeWithFlatTops) {
  const HeightField field = make_surface("cones",
                                         {{"spacing_m", 0.005},
                                          {"height_m", 3e-4},
                                          {"top_diameter_m", 0.001},
                                          {"base_diameter_m", 0.003},
                                          {"jitter", 0.0}},
                                         {.width_m = 0.05, .pixels = 1000});
  const auto height_m = [&](double x_m) {
    return field.sample(x_m, 0.0025, Tiling::repeat).height_m;
  };
  EXPECT_NEAR(height_m(0.0025), 3e-4, 1e-9);             // axis
  EXPECT_NEAR(height_m(0.0025 + 0.0004), 3e-4, 1e-9);    // on the top
  EXPECT_NEAR(height_m(0.0025 + 0.0010), 1.5e-4, 3e-6);  // half way down: (1.5 − 1.0)/(1.5 − 0.5)
  EXPECT_NEAR(height_m(0.0025 + 0.0020), 0.0, 1e-9);     // ground
}

TEST(Cones, AreShiftedByJitter) {
  const SurfaceCanvas canvas{.width_m = 0.05, .pixels = 500, .seed = 3};
  const HeightField straight = make_surface("cones", {{"jitter", 0.0}}, canvas);
  const HeightField shifted = make_surface("cones", {{"jitter", 0.2}}, canvas);
  EXPECT_NE(straight.heights_m(), shifted.heights_m());
  EXPECT_NEAR(straight.mean_m(), shifted.mean_m(), 0.02 * straight.mean_m());  // none was lost
}

constexpr double kThreeToFour_rad = 0.643501;  // arctan(3/4)

// A row and a column of a lattice turned by arctan(3/4): steps of L·(4, 3)/5 and L·(−3, 4)/5, through several borders.
TEST(Cones, StandInTurnedRowsThatContinueAcrossTheBorders) {
  const SurfaceCanvas canvas{.width_m = 0.02, .pixels = 800};
  const ParameterValues straight{{"spacing_m", 0.002}, {"jitter", 0.0}};
  ParameterValues turned = straight;
  turned["angle_rad"] = kThreeToFour_rad;
  const HeightField field = make_surface("cones", turned, canvas);
  const auto height_m = [&field](double x_m, double y_m) {
    return field.sample(x_m, y_m, Tiling::repeat).height_m;
  };
  const double first_x_m = 0.001 * (0.8 - 0.6);  // half a spacing along and across, from the middle
  const double first_y_m = 0.001 * (0.6 + 0.8);
  for (int step = -20; step <= 20; ++step) {
    const double way_m = 0.002 * step;
    EXPECT_NEAR(height_m(first_x_m + 0.8 * way_m, first_y_m + 0.6 * way_m), 4e-4, 1e-6) << step;
    EXPECT_NEAR(height_m(first_x_m - 0.6 * way_m, first_y_m + 0.8 * way_m), 4e-4, 1e-6) << step;
    EXPECT_NEAR(height_m(first_x_m + 0.8 * (way_m + 0.001), first_y_m + 0.6 * (way_m + 0.001)), 0.0,
                1e-6)
        << step;
  }
  const HeightField as_many = make_surface("cones", straight, canvas);
  EXPECT_NEAR(field.mean_m() / as_many.mean_m(), 1.0, 0.01);
  EXPECT_THAT(surface_refusal("cones", turned, {.width_m = 0.022, .pixels = 800}),
              HasSubstr("contains 8.8"));
  turned["angle_rad"] = 0.5;
  EXPECT_THAT(surface_refusal("cones", turned, canvas), HasSubstr("do not continue across"));
}

// Courses of 10 mm: at y = 0 the middle of one, at 5 mm a joint, 0.4 mm deep all along.
TEST(Brick, HasACourseInItsMiddle) {
  const HeightField field = make_surface("brick", {{"face_rms_m", 0.0}}, {});
  double course_m = 0.0;
  double joint_m = 0.0;
  constexpr int kSamples = 1000;
  for (int k = 0; k < kSamples; ++k) {
    const double x_m = 1e-4 * k;
    course_m += field.sample(x_m, 0.0, Tiling::repeat).height_m / kSamples;
    joint_m += field.sample(x_m, 0.005, Tiling::repeat).height_m / kSamples;
  }
  EXPECT_NEAR(joint_m, -4e-4, 1e-6);
  // A head joint takes 1.6 mm of every 20 mm.
  EXPECT_NEAR(course_m, -4e-4 * 1.6 / 20.0, 1e-5);
}

TEST(Noise, HasItsRmsAndOnlyItsWavelengths) {
  const HeightField field = make_surface(
      "noise", {{"rms_m", 5e-5}, {"shortest_wavelength_m", 0.002}, {"longest_wavelength_m", 0.004}},
      {.width_m = 0.05, .pixels = 256});
  EXPECT_NEAR(field.rms_m(), 5e-5, 1e-9);
  EXPECT_NEAR(field.mean_m(), 0.0, 1e-9);
  // Mean square slope over mean square height is (2π)² times the mean square wavenumber, which lies
  // between those of the two ends: 250 and 500 per metre.
  double slopes2 = 0.0;
  double heights2 = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const HeightSample at = field.sample(3.1e-6 * k, 1.7e-5 * k, Tiling::repeat);
    slopes2 += at.slope_x * at.slope_x + at.slope_y * at.slope_y;
    heights2 += at.height_m * at.height_m;
  }
  const double wavenumber_per_m = std::sqrt(slopes2 / heights2) / (2.0 * std::numbers::pi);
  EXPECT_GT(wavenumber_per_m, 250.0);
  EXPECT_LT(wavenumber_per_m, 500.0);
}

TEST(SyntheticSurface, RefusesWhatCannotBeMadeByItsName) {
  EXPECT_THAT(surface_refusal("marble", {}, {}),
              HasSubstr("no synthetic surface \"marble\"; choose one of: sinusoid,"));
  EXPECT_THAT(surface_refusal("wood", {{"grain_m", 1.0}}, {}),
              HasSubstr("wood has no parameter \"grain_m\""));
  EXPECT_THAT(surface_refusal("wood", {}, {.width_m = 2.0}), HasSubstr("width_m is 2 m"));
  EXPECT_THAT(surface_refusal("wood", {}, {.pixels = 8}), HasSubstr("pixels is 8"));
  EXPECT_THAT(surface_refusal("sinusoid", {{"spacing_m", 1e-4}}, {}), HasSubstr("increase pixels"));
  EXPECT_THAT(surface_refusal("grating", {{"spacing_m", 1e-3}}, {}),
              HasSubstr("wider than spacing_m"));
  EXPECT_THAT(surface_refusal("cones", {{"top_diameter_m", 0.002}}, {}),
              HasSubstr("smaller than base"));
  EXPECT_THAT(surface_refusal("noise", {{"longest_wavelength_m", 3e-4}}, {}),
              HasSubstr("shorter than"));
}

// What a point probe feels on a straight to-and-fro stroke along x that drifts a little in y, at
// 60 mm/s, pressed to 1 N on 500 N/m: the force follows the height.
ForceFeatures felt(const HeightField& field, double from_y_m) {
  std::vector<double> time_s;
  std::vector<double> travel_m;
  std::vector<double> normal_N;
  std::vector<double> lateral_N;
  for (int k = 0; k < 4000; ++k) {
    const double s_m = 60e-6 * k;
    const HeightSample at = field.sample(-0.04 + std::abs(std::fmod(s_m, 0.16) - 0.08),
                                         from_y_m + 0.05 * s_m, Tiling::repeat);
    time_s.push_back(1e-3 * k);
    travel_m.push_back(s_m);
    normal_N.push_back(std::max(0.0, 1.0 + 500.0 * at.height_m));
    lateral_N.push_back(normal_N.back() * (0.2 + at.slope_x));
  }
  return force_features(
      {.time_s = time_s, .travel_m = travel_m, .normal_N = normal_N, .lateral_N = lateral_N});
}

// How often each piece of a material, stroked elsewhere, is closer to another material than
// 1/margin of its distance to its own.
std::vector<std::string> confusions(double margin,
                                    const std::function<HeightField(HeightField)>& of) {
  std::vector<ForceFeatures> expected;
  for (const std::string& kind : kMaterials) {
    expected.push_back(felt(of(make_surface(kind, {}, {})), 0.013));
  }
  std::vector<std::string> found;
  for (std::size_t own = 0; own < kMaterials.size(); ++own) {
    for (const std::uint64_t seed : {2, 3}) {
      const ForceFeatures here =
          felt(of(make_surface(kMaterials[own], {}, {.seed = seed})), -0.021);
      const double to_own = squared_distance(here, expected[own]);
      for (std::size_t other = 0; other < kMaterials.size(); ++other) {
        if (other != own && margin * to_own >= squared_distance(here, expected[other])) {
          found.push_back(kMaterials[own] + " as " + kMaterials[other]);
        }
      }
    }
  }
  return found;
}

TEST(Materials, AreRecognisedByAStrokeAlongX) {
  EXPECT_THAT(confusions(3.0, [](HeightField field) { return field; }), ::testing::IsEmpty());
}

TEST(Materials, AreRecognisedByTheirShapeAloneAtOneAmplitude) {
  const auto at_one_amplitude = [](const HeightField& field) {
    std::vector<float> heights_m = field.heights_m();
    for (float& height_m : heights_m) {
      height_m = static_cast<float>(6e-5 * (static_cast<double>(height_m) - field.mean_m()) /
                                    field.rms_m());
    }
    return HeightField(field.grid(), heights_m);
  };
  EXPECT_THAT(confusions(3.0, at_one_amplitude), ::testing::IsEmpty());
}

}  // namespace
}  // namespace asperity
