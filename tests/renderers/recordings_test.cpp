// Recorded textures: their table, their spectra, and the one that is computed from a relief.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/recordings/recorded_spectra.h"
#include "renderers/recordings/relief_recording.h"
#include "renderers/recordings/texture_recording.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TextureRecording small_recording() {
  TextureRecording recording{};
  for (const double speed_m_per_s : {0.05, 0.1}) {
    RecordedStroke stroke{};
    for (int i = 0; i < 80; ++i) {
      stroke.time_s.push_back(i / 1000.0);
      stroke.path_m.push_back(speed_m_per_s * i / 1000.0);
      stroke.normal_N.push_back(0.1 * (1 + i % 3));
      stroke.force_N.push_back(std::sin(0.3 * i));
    }
    recording.strokes.push_back(stroke);
  }
  return recording;
}

std::string refusal_of_table(const std::string& tsv) {
  return refusal_of<std::invalid_argument>([&] { texture_recording_in(tsv, "felt.tsv"); });
}

std::string replaced_once(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// 200 samples of a mean speed of 0.1 m/s and a mean normal force of 1 N; both are functions of the part of the stroke, 0 to 1.
TextureRecording uneven_stroke(double (*speed)(double), double (*normal)(double)) {
  RecordedStroke stroke{};
  double path_m = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double part = i / 199.0;
    stroke.time_s.push_back(i / 1000.0);
    stroke.path_m.push_back(path_m);
    path_m += 0.1 * speed(part) / 1000.0;
    stroke.normal_N.push_back(normal(part));
    stroke.force_N.push_back(std::sin(0.3 * i));
  }
  return {.strokes = {stroke}};
}

TEST(TextureRecording, NamesTheStrokesWhoseSpeedOrForceIsNotConstant) {
  const auto constant = [](double) { return 1.0; };
  const auto nearly = [](double part) { return 0.85 + 0.3 * part; };
  const auto rising = [](double part) { return 0.2 + 1.6 * part; };
  EXPECT_TRUE(uneven_strokes(small_recording()).empty());
  EXPECT_TRUE(uneven_strokes(uneven_stroke(nearly, nearly)).empty());
  EXPECT_THAT(uneven_strokes(uneven_stroke(rising, constant)),
              testing::ElementsAre(
                  testing::AllOf(StartsWith("stroke 1: the speed is not constant, but between 2"),
                                 HasSubstr(" and 17"), HasSubstr(" mm/s; shorten the stroke"))));
  EXPECT_THAT(uneven_strokes(uneven_stroke(constant, rising)),
              testing::ElementsAre(
                  HasSubstr("the normal force is not constant, but between 0.27 and 1.72 N")));
}

TEST(TextureRecording, IsReadAsItWasWritten) {
  const TextureRecording written = small_recording();
  const TextureRecording read = texture_recording_in(tsv_of(written), "felt.tsv");
  ASSERT_EQ(read.strokes.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.strokes[i].time_s, written.strokes[i].time_s);
    EXPECT_EQ(read.strokes[i].path_m, written.strokes[i].path_m);
    EXPECT_EQ(read.strokes[i].normal_N, written.strokes[i].normal_N);
    EXPECT_EQ(read.strokes[i].force_N, written.strokes[i].force_N);
  }
  EXPECT_NEAR(read.strokes[1].speed_m_per_s(), 0.1, 1e-12);
}

TEST(TextureRecording, RefusesATableWithItsLineAndTheCorrection) {
  const std::string table = tsv_of(small_recording());
  EXPECT_THAT(refusal_of_table(""), StartsWith("felt.tsv:1: the column stroke is missing"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "force_N\n", "force_mN\n")),
              StartsWith("felt.tsv:1: the column force_N is missing"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "force_N\n", "force_N\tnote\n")),
              HasSubstr("has only the columns"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "\n1\t0\t", "\n1\tnan\t")),
              StartsWith("felt.tsv:2: the column time_s has \"nan\", which is not a finite "
                         "number; correct it"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "\n1\t0\t", "\n1\t0,5\t")),
              StartsWith("felt.tsv:2: the column time_s has \"0,5\", with a decimal comma; write a "
                         "decimal point"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "\n1\t0\t", "\n1\t\u00a00\t")),
              StartsWith("felt.tsv:2: the column time_s has \"\u00a00\", with a no-break space "
                         "(U+00A0); delete it"));
  EXPECT_THAT(refusal_of_table("stroke\ttime_s\r1\t0\r"),
              StartsWith("felt.tsv:1: the lines end with carriage returns alone"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "\n1\t0\t", "\n1\t")),
              StartsWith("felt.tsv:2: the row has 4 cells"));
  EXPECT_THAT(refusal_of_table(table + "1\t9\t9\t1\t0\n"),
              HasSubstr("stroke 1 has rows in two places"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "\n1\t0.001\t", "\n1\t0.5\t")),
              HasSubstr("stroke 1 has a time_s that does not increase"));
  EXPECT_THAT(refusal_of_table(replaced_once(table, "\n1\t0.001\t", "\n1\t0.001\t9")),
              HasSubstr("stroke 1 has a path_m that decreases"));
  EXPECT_THAT(refusal_of_table(table.substr(0, table.find("\n2\t0.01\t"))),
              HasSubstr("stroke 2 has 10 samples; record at least 64"));
  TextureRecording lifted = small_recording();
  for (double& normal_N : lifted.strokes[1].normal_N) normal_N = 0.0;
  EXPECT_THAT(refusal_of_table(tsv_of(lifted)),
              HasSubstr("stroke 2 has a mean normal force of 0 N"));
  TextureRecording still = small_recording();
  for (double& path_m : still.strokes[0].path_m) path_m = 0.0;
  EXPECT_THAT(refusal_of_table(tsv_of(still)), HasSubstr("stroke 1 does not move"));
}

// Windows ends lines in two characters, some of its programs begin a file with a mark, and columns come in any order.
TEST(TextureRecording, ReadsOtherLineEndsAndOrdersAndAByteOrderMark) {
  std::string table =
      "\xEF\xBB\xBF"
      "force_N\tstroke\ttime_s\tnormal_force_N\tpath_m\r\n";
  for (int i = 0; i < 70; ++i) {
    table += std::to_string(0.5 * i) + "\t7\t" + std::to_string(0.001 * i) + "\t1\t" +
             std::to_string(0.0001 * i) + "\r\n";
  }
  const TextureRecording read = texture_recording_in(table, "felt.tsv");
  ASSERT_EQ(read.strokes.size(), 1U);
  EXPECT_EQ(read.strokes[0].force_N[3], 1.5);
  EXPECT_NEAR(read.strokes[0].speed_m_per_s(), 0.1, 1e-12);
}

// Power is neither made nor lost: Σ A²/2 over all lines is the mean square of the stroke below 0.45 of its rate.
TEST(RecordedSpectra, HaveTheMeanSquareOfTheStroke) {
  TextureRecording recording{};
  for (const int waves : {7, 21}) {
    RecordedStroke stroke{};
    for (int i = 0; i < 1000; ++i) {
      stroke.time_s.push_back(i / 1000.0);
      stroke.path_m.push_back(0.01 * waves * i / 1000.0);
      stroke.normal_N.push_back(2.0);
      stroke.force_N.push_back(3.0 + 0.4 * std::sin(2.0 * std::numbers::pi * waves * i / 1000.0));
    }
    recording.strokes.push_back(stroke);
  }
  const RecordedSpectra spectra(recording, SpectrumAxis::spatial, 1.0);
  ASSERT_EQ(spectra.speeds_m_per_s().size(), 2U);
  for (const double speed_m_per_s : spectra.speeds_m_per_s()) {
    double mean_square = 0.0;
    for (const double amplitude_N : spectra.amplitudes_at(speed_m_per_s)) {
      mean_square += 0.5 * amplitude_N * amplitude_N;
    }
    EXPECT_NEAR(std::sqrt(2.0 * mean_square), 0.2, 0.002);  // 0.4 N under 2 N
  }
  // 7 waves in 70 mm and 21 in 210 mm.
  EXPECT_NEAR(spectra.band(), 100.0, 2.0 * 1.0 / 0.07);
}

// A fast stroke resolves longer waves only: above them the slow one holds at every speed.
TEST(RecordedSpectra, HoldTheNearestSpeedThatCoversAWave) {
  TextureRecording recording{};
  for (const double speed_m_per_s : {0.05, 0.2}) {
    RecordedStroke stroke{};
    for (int i = 0; i < 2000; ++i) {
      const double path_m = speed_m_per_s * i / 1000.0;
      stroke.time_s.push_back(i / 1000.0);
      stroke.path_m.push_back(path_m);
      stroke.normal_N.push_back(1.0);
      // 0.2 mm: 250 Hz at 50 mm/s, and 1 kHz at 200 mm/s, which 1 kHz cannot resolve.
      stroke.force_N.push_back(
          speed_m_per_s < 0.1 ? std::sin(2.0 * std::numbers::pi * path_m / 2e-4) : 0.0);
    }
    recording.strokes.push_back(stroke);
  }
  const RecordedSpectra spectra(recording, SpectrumAxis::spatial, 1.0);
  for (const double speed_m_per_s : {0.05, 0.1, 0.2}) {
    double mean_square = 0.0;
    for (const double amplitude_N : spectra.amplitudes_at(speed_m_per_s)) {
      mean_square += 0.5 * amplitude_N * amplitude_N;
    }
    EXPECT_NEAR(mean_square, 0.5, 0.01) << speed_m_per_s;
  }
}

TEST(RecordedSpectra, TakeStrokesOfNearlyTheSameSpeedTogether) {
  TextureRecording recording = small_recording();
  recording.strokes.push_back(recording.strokes[0]);
  for (double& path_m : recording.strokes[2].path_m) path_m *= 1.05;
  const RecordedSpectra spectra(recording, SpectrumAxis::spatial, 1.0);
  ASSERT_EQ(spectra.speeds_m_per_s().size(), 2U);
  EXPECT_NEAR(spectra.speeds_m_per_s()[0], (1.0 + 1.05 * 1.05) / 2.05 * 0.05, 1e-9);
}

// A sinusoid of amplitude A and length L under N: N·2πA/L, at every speed that resolves it.
TEST(RecordingOfARelief, IsTheSlopeTimesTheNormalForce) {
  constexpr double kAmplitude_m = 1e-4;
  constexpr double kLength_m = 4e-3;
  const auto field = grating({.amplitude_m = kAmplitude_m, .wavelength_m = kLength_m, .rows = 40});
  const TextureRecording recording =
      recording_of_relief(*field, {.speeds_m_per_s = {0.05, 0.1}, .normal_N = 2.0});
  ASSERT_EQ(recording.strokes.size(), 6U);
  for (const RecordedStroke& stroke : recording.strokes) {
    double greatest_N = 0.0;
    for (const double force_N : stroke.force_N) greatest_N = std::max(greatest_N, force_N);
    EXPECT_NEAR(greatest_N, 2.0 * 2.0 * std::numbers::pi * kAmplitude_m / kLength_m, 0.002);
    EXPECT_EQ(stroke.mean_normal_N(), 2.0);
  }
  EXPECT_NEAR(recording.strokes[0].speed_m_per_s(), 0.05, 1e-9);
  EXPECT_NEAR(recording.strokes[5].speed_m_per_s(), 0.1, 1e-9);
  EXPECT_NO_THROW(require_strokes(recording, "it"));
}

TEST(RecordingOfARelief, RefusesAFieldThatIsTooNarrow) {
  EXPECT_THAT(refusal_of<std::invalid_argument>(
                  [] { recording_of_relief(*level(0.0F), {.speeds_m_per_s = {1.0}}); }),
              HasSubstr("too narrow for 64 samples"));
}

}  // namespace
}  // namespace asperity
