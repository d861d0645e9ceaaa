// asperity texture-recording, and the force model that plays its table.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

std::string stroke_as_path() {
  std::string path = "time_s\tx_m\ty_m\tz_m\n";
  for (int i = 0; i < 1000; ++i) {
    path += text_of_number(i / 1000.0) + '\t' + text_of_number(0.06 * i / 1000.0) + "\t0\t-0.002\n";
  }
  return path;
}

/// The RMS of the force along x of the model on a stroke of 60 mm/s, in its second half.
double played_rms_N(const fs::path& place, const fs::path& recording) {
  write_text(place / "path.tsv", stroke_as_path());
  const Outcome rendered = asperity({"render", "--model", "recorded", "--asset",
                                     "recording=" + recording.string(), "--friction", "0", "--path",
                                     place / "path.tsv", "--out", place / "forces.tsv", "--force"});
  EXPECT_EQ(rendered.status, 0) << rendered.err;
  const std::vector<std::string> along = tsv(text_of(place / "forces.tsv")).column("fx_N");
  double sum = 0.0;
  for (std::size_t i = along.size() / 2; i < along.size(); ++i) {
    sum += std::pow(number_in(along[i]).value(), 2);
  }
  return std::sqrt(2.0 * sum / static_cast<double>(along.size()));
}

// A grating of A 0.1 mm and L 2 mm has slopes of up to 2πA/L = 0.314 and of an RMS of 0.22.
TEST(TextureRecording, OfAReliefIsPlayedWithItsSlopes) {
  const TemporaryFolder place{};
  ASSERT_EQ(
      asperity({"synth", "sinusoid", "--param", "amplitude_m=0.0001", "--param", "spacing_m=0.002",
                "--pixels", "500", "--width-m", "0.05", "--out", place / "wave.png"})
          .status,
      0);
  const Outcome made =
      asperity({"texture-recording", "--relief", place / "wave.png", "--out", place / "wave.tsv"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("9 strokes at 3 speeds, 30.0 to 120.0 mm/s"));
  EXPECT_THAT(made.out, HasSubstr("auto_regressive: \"parameters\": {\"coefficient_1\": 1."));
  EXPECT_THAT(made.out, HasSubstr("\"friction_sd\": 0.22"));
  EXPECT_NEAR(played_rms_N(place.path(), place / "wave.tsv"), 0.22, 0.03);
  // Nothing is overwritten.
  EXPECT_EQ(
      asperity({"texture-recording", "--relief", place / "wave.png", "--out", place / "wave.tsv"})
          .status,
      1);
}

std::string wav_of_a_wave(double frequency_Hz, std::uint16_t code) {
  const auto little = [](std::uint32_t value, int bytes) {
    std::string text{};
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFF);
    return text;
  };
  std::string data{};
  for (int i = 0; i < 4000; ++i) {
    const auto sample = static_cast<std::int16_t>(
        std::lround(16384.0 * std::sin(6.2831853 * frequency_Hz * i / 2000.0)));
    data += little(static_cast<std::uint16_t>(sample), 2);
  }
  return "RIFF" + little(static_cast<std::uint32_t>(data.size() + 36), 4) + "WAVEfmt " +
         little(16, 4) + little(code, 2) + little(1, 2) + little(2000, 4) + little(4000, 4) +
         little(2, 2) + little(16, 2) + "data" +
         little(static_cast<std::uint32_t>(data.size()), 4) + data;
}

TEST(TextureRecording, OfWavFilesIsPlayedWithTheForceOfTheirFullScale) {
  const TemporaryFolder place{};
  write_text(place / "slow.wav", wav_of_a_wave(30.0, 1));
  write_text(place / "fast.wav", wav_of_a_wave(90.0, 1));
  const Outcome made =
      asperity({"texture-recording", "--wav", place / "slow.wav", "--speed-m-per-s", "0.03",
                "--wav", place / "fast.wav", "--speed-m-per-s", "0.09", "--full-scale-n", "0.4",
                "--out", place / "felt.tsv"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("2 strokes at 2 speeds, 30.0 to 90.0 mm/s"));
  EXPECT_NEAR(played_rms_N(place.path(), place / "felt.tsv"), 0.2 / std::sqrt(2.0), 0.01);
  // A compressed file is refused by its name.
  write_text(place / "song.wav", wav_of_a_wave(30.0, 85));
  const Outcome refused =
      asperity({"texture-recording", "--wav", place / "song.wav", "--speed-m-per-s", "0.03",
                "--full-scale-n", "1", "--out", place / "song.tsv"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("song.wav"), HasSubstr("not PCM"),
                                          HasSubstr("convert the file")));
}

TEST(TextureRecording, OfATableIsTheSameTable) {
  const TemporaryFolder place{};
  write_text(place / "slow.wav", wav_of_a_wave(30.0, 1));
  ASSERT_EQ(asperity({"texture-recording", "--wav", place / "slow.wav", "--speed-m-per-s", "0.03",
                      "--full-scale-n", "0.4", "--out", place / "felt.tsv"})
                .status,
            0);
  const Outcome again =
      asperity({"texture-recording", "--table", place / "felt.tsv", "--out", place / "again.tsv"});
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.err, HasSubstr("all strokes have nearly the same speed"));
  EXPECT_EQ(text_of(place / "felt.tsv"), text_of(place / "again.tsv"));
  write_text(place / "other.tsv", "a\tb\n");
  const Outcome refused = asperity({"texture-recording", "--table", place / "other.tsv", "--out",
                                    place / "again.tsv", "--force"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("other.tsv:1: the column stroke is missing"));
}

// What the virtual hand felt is a recorded texture, and another model plays it under the same hand.
TEST(TextureRecording, OfAStudyIsThatOfItsHand) {
  const SmallStudy small{};
  nlohmann::ordered_json protocol = nlohmann::ordered_json::parse(text_of(small.selection()));
  protocol["explorations"]["short"] = {{"minimum_contact_s", 3.0}, {"maximum_contact_s", 6.0}};
  write_text(small.selection(), protocol.dump());
  ASSERT_EQ(asperity({"simulate", small.selection(), "--study", small.study(), "--participants",
                      "1", "--seed", "3", "--recordings", "all"})
                .status,
            0);
  const fs::path table = small.place() / "hand.tsv";
  const Outcome made =
      asperity({"texture-recording", "--study", small.study(), "--attempt", "1", "--out", table});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("median force over normal force 0."));
  const std::vector<std::string> replay{"replay",    small.study(),
                                        "--attempt", "1",
                                        "--model",   "recorded",
                                        "--param",   "single_speed=accepted",
                                        "--out",     small.place() / "forces.tsv"};
  const Outcome without = asperity(replay);
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.err, HasSubstr("needs the asset \"recording\""));
  std::vector<std::string> with_table = replay;
  with_table.insert(with_table.end(), {"--asset", "recording=" + table.string()});
  const Outcome replayed = asperity(with_table);
  EXPECT_EQ(replayed.status, 0) << replayed.err;
  const Outcome none = asperity({"texture-recording", "--study", small.study(), "--attempt", "1",
                                 "--surface", "9", "--out", small.place() / "none.tsv"});
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("has no stroke of 0.25 s"));
}

TEST(TextureRecording, OfATextureIsReplayedWithoutNamingItsFile) {
  const SmallStudy small{};
  const TemporaryFolder place{};
  ASSERT_EQ(asperity({"synth", "sinusoid", "--param", "spacing_m=0.002", "--width-m", "0.04",
                      "--pixels", "512", "--out", place / "wave.png"})
                .status,
            0);
  ASSERT_EQ(asperity({"texture-recording", "--relief", place / "wave.png", "--out",
                      small.study() / "stimuli/wave.tsv"})
                .status,
            0);
  nlohmann::ordered_json protocol = nlohmann::ordered_json::parse(text_of(small.selection()));
  for (auto& [name, texture] : protocol["textures"].items()) {
    texture["assets"] = {{"recording", "stimuli/wave.tsv"}};
  }
  write_text(small.selection(), protocol.dump());
  ASSERT_EQ(asperity({"simulate", small.selection(), "--study", small.study(), "--participants",
                      "1", "--seed", "3", "--recordings", "all"})
                .status,
            0);
  const Outcome replayed = asperity({"replay", small.study(), "--attempt", "1", "--model",
                                     "recorded", "--out", place / "forces.tsv"});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
}

TEST(TextureRecording, NeedsOneSourceWithItsOptions) {
  const TemporaryFolder place{};
  const Outcome without = asperity({"texture-recording", "--out", place / "x.tsv"});
  EXPECT_EQ(without.status, 2);
  EXPECT_THAT(without.err, HasSubstr("--relief, --wav, --study and --table"));
  const Outcome speeds = asperity({"texture-recording", "--wav", "a.wav", "--wav", "b.wav",
                                   "--speed-m-per-s", "0.03", "--out", place / "x.tsv"});
  EXPECT_EQ(speeds.status, 2);
  EXPECT_THAT(speeds.err, HasSubstr("--wav names 2 files, and --speed-m-per-s gives 1 speed"));
  const Outcome scale = asperity(
      {"texture-recording", "--wav", "a.wav", "--speed-m-per-s", "0.03", "--out", place / "x.tsv"});
  EXPECT_EQ(scale.status, 2);
  EXPECT_THAT(scale.err, HasSubstr("--full-scale-n"));
  const Outcome attempt =
      asperity({"texture-recording", "--study", place.path(), "--out", place / "x.tsv"});
  EXPECT_EQ(attempt.status, 2);
  EXPECT_THAT(attempt.err, HasSubstr("--attempt"));
}

}  // namespace
}  // namespace asperity::test
