// Vibration models: their table, their interpolation, their fit to recordings, and the textures of the toolkit.

#include "renderers/vibrations/vibration_models.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/signals/autoregression.h"
#include "analysis/signals/band_limited.h"
#include "renderers/vibrations/haptic_texture_toolkit.h"
#include "renderers/vibrations/vibration_fit.h"
#include "renderers/vibrations/vibration_map.h"
#include "tests/renderers/vibrations.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(VibrationModels, AreReadAsTheyWereWritten) {
  const VibrationModels written = resonant_models();
  const VibrationModels read = vibration_models_in(tsv_of(written), "wood.tsv");
  ASSERT_EQ(read.models.size(), written.models.size());
  for (std::size_t i = 0; i < read.models.size(); ++i) {
    EXPECT_EQ(read.models[i].speed_m_per_s, written.models[i].speed_m_per_s);
    EXPECT_EQ(read.models[i].normal_N, written.models[i].normal_N);
    EXPECT_EQ(read.models[i].variance_m2_per_s4, written.models[i].variance_m2_per_s4);
    EXPECT_EQ(read.models[i].lines_rad, written.models[i].lines_rad);
  }
}

TEST(VibrationModels, RefuseATableWithItsLineAndTheCorrection) {
  const auto refusal = [](const std::string& tsv) {
    return refusal_of<std::invalid_argument>([&] { vibration_models_in(tsv, "wood.tsv"); });
  };
  const std::string head = "speed_m_per_s\tnormal_force_N\tvariance_m2_per_s4\tline_1_rad\n";
  EXPECT_THAT(refusal(""), StartsWith("wood.tsv:1: the column speed_m_per_s is missing"));
  EXPECT_THAT(refusal(replaced(head, "line_1_rad", "line_2_rad")),
              StartsWith("wood.tsv:1: the column line_1_rad is missing"));
  EXPECT_THAT(refusal(head), StartsWith("wood.tsv: there is no model"));
  EXPECT_THAT(refusal(head + "0.1\t1\n"), StartsWith("wood.tsv:2: the row has 2 cells"));
  EXPECT_THAT(refusal(head + "0.1\t1\tloud\t1\n"),
              StartsWith("wood.tsv:2: the column variance_m2_per_s4 has \""));
  EXPECT_THAT(refusal(head + "0.1\t1\t0.1\t1\n0.2\t-1\t0.1\t1\n"),
              StartsWith("wood.tsv:3: the model has the normal_force_N -1"));
  EXPECT_THAT(refusal(head + "0.1\t1\t0.1\t3.2\n"), HasSubstr("to below pi"));
  EXPECT_THAT(refusal(head + "0.1\t1\t0\t1\n"), HasSubstr("silent"));
  EXPECT_THAT(refusal(head + "0.1\t1\t0.1\t1\n0.2\t1\t0.1\t1\n0.1\t1\t0.3\t1\n"),
              StartsWith("wood.tsv: the models 1 and 3 have the same speed and normal force"));
}

TEST(VibrationMap, IsEachModelAtItsPlaceAndTheMeanBetweenTwo) {
  const VibrationModels set = resonant_models();
  const VibrationMap logarithmic(set, VarianceLaw::logarithmic, "set");
  const VibrationMap linear(set, VarianceLaw::linear, "set");
  std::size_t triangle = 0;
  std::vector<double> coefficients(4);
  std::vector<double> expected(4);
  for (const VibrationModel& model : set.models) {
    const VibrationMap::Place place{model.speed_m_per_s, model.normal_N};
    const double sd = logarithmic.filter_at(place, triangle, coefficients);
    EXPECT_NEAR(sd * sd / model.variance_m2_per_s4, 1.0, 1e-12);
    coefficients_of_lines(model.lines_rad, expected);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(coefficients[i], expected[i], 1e-12);
  }
  // Between models 0 and 1, which are on a side of the hull.
  const double a = set.models[0].variance_m2_per_s4;
  const double b = set.models[1].variance_m2_per_s4;
  const VibrationMap::Place between{0.03, 0.75};
  EXPECT_NEAR(std::pow(logarithmic.filter_at(between, triangle, coefficients), 2), std::sqrt(a * b),
              1e-12);
  EXPECT_NEAR(std::pow(linear.filter_at(between, triangle, coefficients), 2), 0.5 * (a + b), 1e-12);
}

// Over the triangles and beyond the hull in small steps: half the step, half the largest change.
TEST(VibrationMap, IsContinuousAcrossSidesAndAtTheHull) {
  const VibrationMap map(resonant_models(), VarianceLaw::logarithmic, "set");
  const auto largest_change = [&map](int steps) {
    std::size_t triangle = 0;
    std::vector<double> before(5, 0.0);
    std::vector<double> now(5, 0.0);
    double largest = 0.0;
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / steps;
      now[4] = map.filter_at({0.08 + 0.09 * std::cos(angle), 1.2 + 1.1 * std::sin(3.0 * angle)},
                             triangle, std::span(now).first(4));
      for (std::size_t k = 0; i > 0 && k < 5; ++k) {
        largest = std::max(largest, std::abs(now[k] - before[k]));
      }
      before = now;
    }
    return largest;
  };
  const double coarse = largest_change(4000);
  EXPECT_GT(coarse, 1e-4);
  EXPECT_LT(largest_change(40'000), 0.12 * coarse);
}

TEST(VibrationMap, HoldsTheNearestPlaceOfTheHull) {
  const VibrationMap map(resonant_models(), VarianceLaw::logarithmic, "set");
  std::size_t triangle = 0;
  std::vector<double> inside(4);
  std::vector<double> outside(4);
  EXPECT_NEAR(map.filter_at({0.08, 2.0}, triangle, inside),
              map.filter_at({0.08, 9.0}, triangle, outside), 1e-12);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(inside[i], outside[i], 1e-12);
  EXPECT_NEAR(map.filter_at({0.03, 0.5}, triangle, inside),
              map.filter_at({0.0, 0.0}, triangle, outside), 1e-12);
}

// The weights are the same from whichever triangle the search begins.
TEST(VibrationMap, FindsThePlaceFromEveryTriangle) {
  const VibrationModels set = resonant_models();
  const VibrationMap map(set, VarianceLaw::logarithmic, "set");
  Random random(2);
  for (int draw = 0; draw < 200; ++draw) {
    const VibrationMap::Place place{0.03 + 0.12 * random.uniform(), 0.5 + 1.5 * random.uniform()};
    for (std::size_t from = 0; from < 8; ++from) {
      std::size_t triangle = from;
      const auto mixture = map.mixture_at(place, triangle);
      double speed_m_per_s = 0.0;
      double normal_N = 0.0;
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(mixture.weights[k], 0.0);
        speed_m_per_s += mixture.weights[k] * set.models[mixture.models[k]].speed_m_per_s;
        normal_N += mixture.weights[k] * set.models[mixture.models[k]].normal_N;
      }
      EXPECT_NEAR(speed_m_per_s, place.speed_m_per_s, 1e-12);
      EXPECT_NEAR(normal_N, place.normal_N, 1e-12);
    }
  }
}

// Models at one normal force are a line, on which the force changes nothing; one model is that of every place.
TEST(VibrationMap, InterpolatesModelsOnALine) {
  VibrationModels set{};
  for (const double speed_m_per_s : {0.15, 0.03, 0.06}) {
    set.models.push_back(resonant_model(
        {.speed_m_per_s = speed_m_per_s, .variance_m2_per_s4 = 10.0 * speed_m_per_s}));
  }
  const VibrationMap map(set, VarianceLaw::linear, "set");
  std::size_t triangle = 0;
  std::vector<double> coefficients(4);
  EXPECT_NEAR(std::pow(map.filter_at({0.045, 7.0}, triangle, coefficients), 2), 0.45, 1e-12);
  EXPECT_NEAR(std::pow(map.filter_at({0.105, 0.0}, triangle, coefficients), 2), 1.05, 1e-12);
  const VibrationMap one({{set.models[0]}}, VarianceLaw::linear, "set");
  EXPECT_NEAR(std::pow(one.filter_at({0.5, 0.0}, triangle, coefficients), 2), 1.5, 1e-12);
}

// Recordings of one intended force have means that differ a little: the speed decides alone, also far beyond them.
TEST(VibrationMap, IgnoresDifferencesOfAnAxisThatIsConstantButForChance) {
  VibrationModels set{};
  for (const auto& [speed_m_per_s, normal_N] :
       {std::pair{0.02, 1.00}, std::pair{0.06, 1.02}, std::pair{0.12, 0.98}}) {
    set.models.push_back(resonant_model({.speed_m_per_s = speed_m_per_s,
                                         .normal_N = normal_N,
                                         .variance_m2_per_s4 = 10.0 * speed_m_per_s}));
  }
  const VibrationMap map(set, VarianceLaw::linear, "set");
  std::size_t triangle = 0;
  std::vector<double> coefficients(4);
  for (const double normal_N : {0.5, 1.0, 1.5}) {
    EXPECT_NEAR(std::pow(map.filter_at({0.04, normal_N}, triangle, coefficients), 2), 0.4, 1e-12);
    EXPECT_NEAR(std::pow(map.filter_at({0.09, normal_N}, triangle, coefficients), 2), 0.9, 1e-12);
  }
}

/// A stroke of the process of a model, as a force at 1 kHz.
RecordedStroke stroke_of_model(const VibrationModel& model, double duration_s, std::uint64_t seed) {
  std::vector<double> c(model.lines_rad.size());
  coefficients_of_lines(model.lines_rad, c);
  Random random(seed);
  std::vector<double> a(500 + static_cast<std::size_t>(1000.0 * duration_s), 0.0);
  for (std::size_t i = c.size(); i < a.size(); ++i) {
    a[i] = std::sqrt(model.variance_m2_per_s4) * random.normal();
    for (std::size_t j = 0; j < c.size(); ++j) a[i] += c[j] * a[i - 1 - j];
  }
  RecordedStroke stroke{};
  for (std::size_t i = 500; i < a.size(); ++i) {
    const double time_s = static_cast<double>(i - 500) / 1000.0;
    stroke.time_s.push_back(time_s);
    stroke.path_m.push_back(model.speed_m_per_s * time_s);
    stroke.normal_N.push_back(model.normal_N);
    stroke.force_N.push_back(0.3 + kEffectiveMass_kg * a[i]);
  }
  return stroke;
}

TEST(VibrationFit, RecoversTheSpectraOfModelsFromTenSeconds) {
  const VibrationModels set = resonant_models();
  TextureRecording recording{};
  for (std::size_t i = 0; i < set.models.size(); ++i) {
    // In two strokes, which are one model.
    recording.strokes.push_back(stroke_of_model(set.models[i], 5.0, 2 * i + 1));
    recording.strokes.push_back(stroke_of_model(set.models[i], 5.0, 2 * i + 2));
  }
  const VibrationFit fit = fitted_vibrations(recording, "strokes");
  ASSERT_EQ(fit.set.models.size(), 9U);
  EXPECT_EQ(fit.order, 4U);  // that of the process
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(fit.set.models[i].speed_m_per_s, set.models[i].speed_m_per_s, 1e-9);
    EXPECT_NEAR(fit.set.models[i].normal_N, set.models[i].normal_N, 1e-9);
    EXPECT_LT(largest_difference_dB(fit.set.models[i], set.models[i]), 1.0) << i;
    EXPECT_EQ(fit.strokes[i].strokes, 2U);
    EXPECT_NEAR(std::sqrt(fit.set.models[i].variance_m2_per_s4 / set.models[i].variance_m2_per_s4),
                1.0, 0.03);
  }
}

struct PolePair {
  double frequency_Hz = 0.0;
  double radius = 0.0;
};

/// An autoregressive model of order 4.
VibrationModel model_of_poles(const PolePair& a, const PolePair& b, double variance_m2_per_s4) {
  const auto twice_real = [](const PolePair& pair) {
    return 2.0 * pair.radius *
           std::cos(2.0 * std::numbers::pi * pair.frequency_Hz / kVibrationRate_Hz);
  };
  const double p = twice_real(a);
  const double q = a.radius * a.radius;
  const double r = twice_real(b);
  const double s = b.radius * b.radius;
  // (1 − p·z⁻¹ + q·z⁻²)·(1 − r·z⁻¹ + s·z⁻²)
  const std::vector<double> coefficients{p + r, -(q + s + p * r), p * s + q * r, -q * s};
  return {.speed_m_per_s = 0.03,
          .normal_N = 1.0,
          .variance_m2_per_s4 = variance_m2_per_s4,
          .lines_rad = line_spectral_frequencies(coefficients)};
}

// Of these processes σ² is 4·10⁻⁴, 3·10⁻³ and 8·10⁻⁵ of the variance. White noise of 10⁻⁴ of the variance would change third
// octaves by 13, 3 and 20 dB, and σ by factors of 2.3, 1.2 and 3.7.
TEST(VibrationFit, KeepsResonancesWhosePolesAreNearTheCircle) {
  for (const VibrationModel& model : {model_of_poles({30.0, 0.98}, {110.0, 0.864}, 8.2e-4),
                                      model_of_poles({60.0, 0.995}, {200.0, 0.9}, 1e-3),
                                      model_of_poles({25.0, 0.95}, {60.0, 0.864}, 8.2e-4)}) {
    const VibrationFit fit =
        fitted_vibrations({{stroke_of_model(model, 60.0, 11)}}, "strokes", {.order = 4});
    const VibrationModel& fitted = fit.set.models.at(0);
    EXPECT_LT(largest_difference_dB(fitted, model), 1.0);
    EXPECT_NEAR(std::sqrt(fitted.variance_m2_per_s4 / model.variance_m2_per_s4), 1.0, 0.02);
  }
}

// At 4 kHz, band-limited between the samples of the process.
TEST(VibrationFit, OfAFasterRecordingIsThatOfItsSamplesAtOneKilohertz) {
  const VibrationModel model = resonant_model({});
  const RecordedStroke slow = stroke_of_model(model, 10.0, 7);
  const BandLimitedInterpolation between;
  RecordedStroke fast{};
  for (std::size_t i = 0; i + 4 < 4 * slow.time_s.size(); ++i) {
    const double place = 0.25 * static_cast<double>(i);
    fast.time_s.push_back(place / 1000.0);
    fast.path_m.push_back(model.speed_m_per_s * place / 1000.0);
    fast.normal_N.push_back(1.0);
    fast.force_N.push_back(between.value(slow.force_N, place));
  }
  const VibrationFit fit = fitted_vibrations({{fast}}, "strokes");
  EXPECT_LT(largest_difference_dB(fit.set.models.at(0), model), 1.0);
}

TEST(VibrationFit, TakesTheOrderThatIsAskedForAndRefusesWhatItCannotFit) {
  const RecordedStroke stroke = stroke_of_model(resonant_model({}), 1.0, 3);
  EXPECT_EQ(fitted_vibrations({{stroke}}, "strokes", {.order = 11}).set.models[0].lines_rad.size(),
            11U);
  const auto refusal = [](const RecordedStroke& one, const VibrationFitSettings& settings = {}) {
    return refusal_of<std::invalid_argument>([&] { fitted_vibrations({{one}}, "wood", settings); });
  };
  RecordedStroke slow = stroke;
  for (double& time_s : slow.time_s) time_s *= 2.0;
  EXPECT_THAT(refusal(slow), StartsWith("wood: stroke 1 has 500 samples per second"));
  RecordedStroke flat = stroke;
  std::fill(flat.force_N.begin(), flat.force_N.end(), 0.4);
  EXPECT_THAT(refusal(flat), StartsWith("wood: stroke 1 has no vibration"));
  RecordedStroke brief = stroke_of_model(resonant_model({}), 0.064, 3);
  EXPECT_THAT(refusal(brief, {.order = 32}), HasSubstr("choose a lower order"));
  for (double& time_s : brief.time_s) time_s *= 0.25;
  EXPECT_THAT(refusal(brief), HasSubstr("record strokes of at least 0.1 s"));
}

TEST(VibrationFit, RefusesForcesWhoseSquaresAreNoNumbers) {
  TextureRecording recording{};
  recording.strokes.push_back(stroke_of_model(resonant_model({}), 2.0, 1));
  for (double& force_N : recording.strokes.front().force_N) force_N *= 1e160;
  EXPECT_THROW(fitted_vibrations(recording, "felt.tsv", {.order = 4}), std::invalid_argument);
}

// A pure wave has poles on the circle, which the fit moves inside; its mean square stays.
TEST(VibrationFit, OfAWaveIsStationaryWithItsMeanSquare) {
  RecordedStroke stroke = stroke_of_model(resonant_model({}), 1.0, 3);
  for (std::size_t i = 0; i < stroke.force_N.size(); ++i) {
    stroke.force_N[i] = kEffectiveMass_kg * std::sin(2.0 * std::numbers::pi * 0.06 * double(i));
  }
  const VibrationFit fit = fitted_vibrations({{stroke}}, "strokes", {.order = 2});
  double mean_square = 0.0;
  for (double f = 0.025; f < 500.0; f += 0.05) {
    mean_square += 0.05 * acceleration_density(fit.set.models[0], f);
  }
  EXPECT_NEAR(mean_square, 0.5, 0.01);
}

/// A texture of the toolkit's form with two models.
std::string toolkit_xml(const std::string& moving) {
  const std::string lines =
      "<ARlsf>\n<value>0.5</value>\n<value>0.8</value>\n<value>2.0</value></ARlsf>\n" + moving;
  return "<?xml version=\"1.0\"?>\n<!-- ours -->\n<modelSet texture=\"0\">\n"
         "<AccelUnits>m/s^2</AccelUnits>\n<SpeedUnits>mm/s</SpeedUnits>\n"
         "<ForceUnits>N</ForceUnits>\n<SampleRate>1000</SampleRate>\n<mu>0.25</mu>\n"
         "<model><modNum>1</modNum>\n" +
         lines + "<var>0.000000</var><speedMod>0</speedMod><forceMod>0.5</forceMod></model>\n" +
         "<model><modNum>2</modNum>\n" + lines +
         "<var>0.04</var><speedMod>120.5</speedMod><forceMod>0.5</forceMod></model>\n</modelSet>\n";
}

TEST(ToolkitTexture, HasTheModelsOfItsFileInSiUnits) {
  const ToolkitTexture texture = toolkit_texture_in(toolkit_xml(""), "abs.xml");
  ASSERT_EQ(texture.set.models.size(), 2U);
  const VibrationModel& model = texture.set.models[1];
  EXPECT_NEAR(model.speed_m_per_s, 0.1205, 1e-12);
  EXPECT_EQ(model.normal_N, 0.5);
  EXPECT_EQ(model.variance_m2_per_s4, 0.04);
  EXPECT_EQ(model.lines_rad, (std::vector<double>{0.5, 0.8, 2.0}));
  EXPECT_EQ(texture.silent, 1U);
  EXPECT_FALSE(texture.has_moving_average);
  EXPECT_EQ(texture.friction, 0.25);
}

TEST(ToolkitTexture, IsRefusedWhereItContradictsItself) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    const std::string xml = replaced(toolkit_xml(""), from, to);
    return refusal_of<std::invalid_argument>([&] { toolkit_texture_in(xml, "abs.xml"); });
  };
  EXPECT_THAT(refusal("<var>0.04</var>", "<var>0.04</var>\n<var>9</var>"),
              testing::AllOf(testing::StartsWith("abs.xml:21: the element model has a second var"),
                             testing::HasSubstr("after that of line 20")));
  EXPECT_THAT(refusal("<mu>0.25</mu>", "<mu>0.25</mu><mu>0.3</mu>"),
              testing::HasSubstr("second mu"));
  EXPECT_THAT(refusal("<mu>0.25</mu>", "<mu>1e308</mu>"), testing::HasSubstr("mu is 1e+308"));
  EXPECT_THAT(refusal("<mu>0.25</mu>", "<mu>-0.1</mu>"), testing::HasSubstr("mu is -0.1"));
  EXPECT_EQ(refusal("<mu>0.25</mu>", "<mu>2</mu><numMod>2</numMod>"), "");
  EXPECT_THAT(refusal("<mu>0.25</mu>", "<mu>0.25</mu><numMod>99</numMod>"),
              testing::HasSubstr("numMod is 99, and the file has 2 models"));
}

// The density of the file's process, 2·var·g²·|B|²/(f_s·|A|²), from its own polynomials: B = 1 − 2·cos(w)·… of two lines.
TEST(ToolkitTexture, ReplacesMovingAveragesByTheSameSpectrum) {
  const ToolkitTexture texture = toolkit_texture_in(
      toolkit_xml("<MAlsf><value>0.9</value><value>1.4</value></MAlsf><gain>3</gain>\n"),
      "abs.xml");
  EXPECT_TRUE(texture.has_moving_average);
  EXPECT_LT(texture.largest_difference_dB, 0.2);
  EXPECT_GT(texture.largest_difference_dB, 0.0);
  const VibrationModel& model = texture.set.models[1];
  EXPECT_EQ(model.lines_rad.size(), 20U);
  // An autoregressive model with the lines of B has the density of 1/|B|².
  const VibrationModel a{.variance_m2_per_s4 = 9.0 * 0.04, .lines_rad = {0.5, 0.8, 2.0}};
  const VibrationModel b{.variance_m2_per_s4 = 500.0, .lines_rad = {0.9, 1.4}};
  for (const double centre_Hz : kThirdOctaves_Hz) {
    const FrequencyBand band = third_octave(centre_Hz);
    double theory = 0.0;
    double replaced = 0.0;
    for (int i = 0; i < 100; ++i) {
      const double f = band.low_Hz + (i + 0.5) / 100.0 * (band.high_Hz - band.low_Hz);
      theory += acceleration_density(a, f) / acceleration_density(b, f);
      replaced += acceleration_density(model, f);
    }
    EXPECT_NEAR(10.0 * std::log10(replaced / theory), 0.0, 0.2) << centre_Hz;
  }
}

TEST(ToolkitTexture, RefusesAFileWithItsLineAndTheCorrection) {
  const auto refusal = [](const std::string& xml) {
    return refusal_of<std::invalid_argument>([&] { toolkit_texture_in(xml, "abs.xml"); });
  };
  const std::string good = toolkit_xml("");
  EXPECT_THAT(refusal("time_s\tx_m\n"), StartsWith("abs.xml:1: the file is not XML"));
  EXPECT_THAT(refusal("<svg/>"), StartsWith("abs.xml:1: the root element is svg"));
  EXPECT_THAT(refusal(good.substr(0, good.size() / 2)), HasSubstr("copy the file again"));
  EXPECT_THAT(refusal(replaced(good, "mm/s", "m/s")),
              StartsWith("abs.xml:5: SpeedUnits is \"m/s\", and only \"mm/s\" is supported"));
  EXPECT_THAT(refusal(replaced(good, "1000", "10000")), StartsWith("abs.xml:7: SampleRate"));
  EXPECT_THAT(refusal(replaced(good, "<var>0.04</var>", "")),
              StartsWith("abs.xml:15: the element model has no var"));
  EXPECT_THAT(refusal(replaced(good, "0.04", "loud")), HasSubstr("has \"loud\""));
  EXPECT_THAT(refusal(replaced(good, "<value>0.8", "<value>0.4")),
              StartsWith("abs.xml:12: the frequencies of ARlsf must increase"));
  EXPECT_THAT(refusal(replaced(good, "</mu>", "</nu>")),
              StartsWith("abs.xml:8: the element mu of line 8 is closed as nu"));
  EXPECT_THAT(refusal(good + "more"), HasSubstr("text after the root element"));
}

}  // namespace
}  // namespace asperity
