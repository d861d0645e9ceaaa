// Sound without a sound card: the stream, its pace, its loss, and what is stored of it.

#include "app/gui/sound/qt_sound.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <numbers>
#include <vector>

#include <QtCore/QElapsedTimer>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/gui/sound/speech_file.h"
#include "tests/gui/sound/fake_card.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

MaskingNoise pink_noise() {
  MaskingNoise noise{};
  noise.kind = MaskingNoise::Kind::pink;
  noise.declared_dBA = 65.0;
  noise.measured_dBA = 64.5;
  noise.verified_by = "M. Weber";
  return noise;
}

TEST(QtSound, IsSilentUntilTheNoiseIsAskedFor) {
  FakeCard card{};
  QtSound sound(pink_noise(), {}, output_of(card));
  ASSERT_TRUE(eventually([&] { return card.opened == 1 && sound.is_running(); }));
  EXPECT_EQ(card.peak, 0.0);
  sound.set_masking(true);
  EXPECT_TRUE(eventually([&] { return card.peak > 0.05; }));
}

TEST(QtSound, IsNotRunningHalfASecondAfterTheLastSamples) {
  FakeCard card{};
  QtSound sound(pink_noise(), {}, output_of(card));
  sound.set_masking(true);
  ASSERT_TRUE(eventually([&] { return card.peak > 0.0; }));
  EXPECT_TRUE(sound.is_running());
  card.stands_still = true;
  ASSERT_TRUE(eventually([&] { return card.left_out > 0; }));
  QElapsedTimer since{};
  since.start();
  ASSERT_TRUE(eventually(
      [&] { return static_cast<double>(since.elapsed()) >= 1e3 * SoundStream::kStandsStill_s; }));
  EXPECT_FALSE(sound.is_running());
  card.stands_still = false;
  EXPECT_TRUE(eventually([&] { return sound.is_running(); }));
}

// A person without noise in their headphones is not masked, whatever else could take samples.
TEST(QtSound, ALostCardIsNotReplacedByTheNullOutputAndIsOpenedAgainWhenItIsBack) {
  FakeCard card{};
  QtSound sound(pink_noise(), {}, output_of(card));
  ASSERT_TRUE(eventually([&] { return sound.is_running(); }));
  card.lost = true;
  ASSERT_TRUE(eventually([&] { return !sound.is_running(); }));
  EXPECT_FALSE(sound.is_null());
  card.lost = false;
  EXPECT_TRUE(eventually([&] { return sound.is_running() && card.opened == 2; }));
}

TEST(QtSound, ABusyWindowDoesNotStopTheStream) {
  FakeCard card{};
  QtSound sound(pink_noise(), {}, output_of(card));
  sound.set_masking(true);
  QElapsedTimer busy{};
  busy.start();
  while (card.peak < 0.05 && busy.elapsed() < kPatience_ms) {  // without an event loop
  }
  EXPECT_GT(card.peak, 0.05);
}

TEST(QtSound, ACardThatCannotBeOpenedIsTriedUntilItCan) {
  FakeCard card{};
  card.lost = true;
  QtSound sound(pink_noise(), {}, output_of(card));
  EXPECT_FALSE(sound.is_running());
  EXPECT_FALSE(sound.is_null()) << "another output would not be heard in these headphones";
  card.lost = false;
  EXPECT_TRUE(eventually([&] { return sound.is_running() && card.opened == 1; }));
}

// A sound server that takes the stream and drops it: open is not heard.
TEST(QtSound, ACardThatDiesAsSoonAsItIsOpenIsNeverRunningAndWhatIsStoredSaysSo) {
  FakeCard card{};
  card.dies = true;
  QtSound sound(pink_noise(), {}, output_of(card));
  EXPECT_EQ(nlohmann::json::parse(sound.description_json()).at("heard"), false);
  bool ran = false;
  ASSERT_TRUE(eventually([&] {
    ran = ran || sound.is_running();
    return card.opened >= 3;
  }));
  EXPECT_FALSE(ran);
  card.dies = false;
  EXPECT_TRUE(eventually([&] { return sound.is_running(); }));
}

// A sound server that is busy or dead, a card pulled out in the very moment.
TEST(QtSound, NobodyWaitsForACardThatDoesNotAnswerAndWhatIsStoredSaysSo) {
  FakeCard card{};
  card.hangs = true;
  {
    QtSound sound(pink_noise(), {}, output_of(card));
    sound.set_masking(true);
    EXPECT_FALSE(sound.is_running());
    EXPECT_EQ(nlohmann::json::parse(sound.description_json()).at("heard"), false);
  }  // the session ends while it still hangs
  EXPECT_EQ(card.opened, 0);
  card.hangs = false;
  ASSERT_TRUE(eventually([&] { return card.opened == 1 && !card.open; }));
  EXPECT_EQ(card.peak, 0.0);
}

// A page that is hidden ends its stream on the windows' thread, which may take 50 ms for nothing.
TEST(QtSound, NobodyWaitsForACardThatHangsWhenItIsToBeClosed) {
  FakeCard card{};
  card.hangs = true;
  constexpr std::size_t kStreams = 20;
  std::vector<std::unique_ptr<SoundStream>> streams{};
  for (std::size_t i = 0; i < kStreams; ++i) {
    streams.push_back(std::make_unique<SoundStream>(output_of(card), SoundStream::Fill{}));
  }
  streams.clear();
  // All of them hang until the card is gone: a program that waited for one would not come here.
  EXPECT_GT(card.users.use_count(), static_cast<long>(kStreams));
}

TEST(QtSound, TheNullOutputTakesSamplesAtTheirRate) {
  std::atomic<std::int64_t> frames{0};
  SoundStream stream(null_output(), [&frames](std::span<float> stereo) {
    frames += static_cast<std::int64_t>(stereo.size() / 2);
  });
  EXPECT_TRUE(stream.output().is_null);
  ASSERT_TRUE(eventually([&] { return frames > 0; }));
  QElapsedTimer clock{};
  clock.start();
  const std::int64_t before = frames;
  ASSERT_TRUE(eventually([&] { return frames - before >= 24000; }));
  // Half a second of samples takes no less; how much more depends on how busy the machine is. What
  // stood in the clock's step before counts for at most a quarter of a second.
  EXPECT_GE(clock.elapsed(), 240);
}

TEST(QtSound, WhatIsStoredNamesNoiseLevelsAndOutput) {
  FakeCard card{};
  QtSound sound(pink_noise(), {}, output_of(card));
  auto stored = nlohmann::json::parse(sound.description_json());
  EXPECT_EQ(stored.at("kind"), "pink");
  EXPECT_EQ(stored.at("gain"), 0.1);
  EXPECT_EQ(stored.at("declared_dBA"), 65.0);
  EXPECT_EQ(stored.at("measured_dBA"), 64.5);
  EXPECT_EQ(stored.at("verified_by"), "M. Weber");
  EXPECT_EQ(stored.at("output"), "Headphones");
  EXPECT_EQ(stored.at("heard"), true);
  EXPECT_EQ(stored.at("buffer_s"), 0.02);
  sound.set_gain(0.05);
  stored = nlohmann::json::parse(sound.description_json());
  EXPECT_EQ(stored.at("gain"), 0.05);
  EXPECT_TRUE(stored.at("measured_dBA").is_null()) << "it was measured at another gain";
  EXPECT_EQ(stored.at("verified_by"), "");
}

TEST(QtSound, TheDefaultOutputIsNullExactlyWhereThereIsNoSoundCard) {
  QtSound sound(pink_noise());
  EXPECT_EQ(sound.is_null(), sound_outputs().empty());
  EXPECT_EQ(nlohmann::json::parse(sound.description_json()).at("heard"), !sound.is_null());
}

TEST(WriteFrames, GivesEachFormWhatItTakes) {
  const std::array<float, 4> stereo = {0.5F, -0.25F, 2.0F, -2.0F};
  std::array<std::int16_t, 4> words{};
  write_frames({.type = SampleForm::Type::int16}, stereo, reinterpret_cast<char*>(words.data()));
  EXPECT_EQ(words, (std::array<std::int16_t, 4>{16384, -8192, 32767, -32767}));
  std::array<float, 2> mono{};
  write_frames({.channels = 1}, stereo, reinterpret_cast<char*>(mono.data()));
  EXPECT_EQ(mono, (std::array<float, 2>{0.125F, 0.0F}));
  std::array<float, 8> quad{};
  write_frames({.channels = 4}, stereo, reinterpret_cast<char*>(quad.data()));
  EXPECT_EQ(quad, (std::array<float, 8>{0.5F, -0.25F, 0.0F, 0.0F, 2.0F, -2.0F, 0.0F, 0.0F}));
}

/// A WAV file with the given 16-bit samples, channels in turn.
std::filesystem::path write_wav(const QTemporaryDir& folder, std::uint16_t channels,
                                std::uint16_t bits, const std::vector<std::int16_t>& samples) {
  const std::filesystem::path file = folder.filePath("word.wav").toStdString();
  std::ofstream out(file, std::ios::binary);
  const auto put = [&out](auto value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const auto bytes = static_cast<std::uint32_t>(samples.size() * 2);
  const auto block = static_cast<std::uint16_t>(channels * bits / 8);
  out << "RIFF";
  put(bytes + 36);
  out << "WAVEfmt ";
  put(std::uint32_t{16});
  put(std::uint16_t{1});
  put(channels);
  put(std::uint32_t{16000});
  put(std::uint32_t{16000} * block);
  put(block);
  put(bits);
  out << "data";
  put(bytes);
  out.write(reinterpret_cast<const char*>(samples.data()), bytes);
  return file;
}

TEST(SpeechFile, ReadsOneChannelAndAveragesTwo) {
  QTemporaryDir folder{};
  const auto mono = read_speech(write_wav(folder, 1, 16, {0, 16384, -32768}));
  EXPECT_EQ(mono.rate_Hz, 16000.0);
  EXPECT_EQ(mono.samples, (std::vector<float>{0.0F, 0.5F, -1.0F}));
  const auto stereo = read_speech(write_wav(folder, 2, 16, {16384, 0, -32768, -32768}));
  EXPECT_EQ(stereo.samples, (std::vector<float>{0.25F, -1.0F}));
}

TEST(SpeechFile, SaysWhatIsWrongWithAFile) {
  QTemporaryDir folder{};
  const auto said = [](const std::filesystem::path& file) {
    return QString::fromStdString(refusal_of<std::runtime_error>([&] { read_speech(file); }));
  };
  EXPECT_TRUE(said(folder.filePath("none.wav").toStdString()).contains("cannot be read"));
  EXPECT_TRUE(said(write_wav(folder, 1, 8, {1, 2, 3})).contains("is not 16-bit PCM"));
  EXPECT_TRUE(said(write_wav(folder, 1, 16, std::vector<std::int16_t>(31 * 16000)))
                  .contains("longer than 30 s"));
  const std::filesystem::path text = folder.filePath("text.wav").toStdString();
  std::ofstream(text) << std::string(200, 'x');
  EXPECT_TRUE(said(text).contains("is not a WAV file"));
}

TEST(QtSound, PlaysTheRecordedWordOfItsProtocol) {
  QTemporaryDir folder{};
  std::vector<std::int16_t> word(1600);
  for (std::size_t i = 0; i < word.size(); ++i) {
    word[i] = static_cast<std::int16_t>(8000.0 * std::sin(0.2 * static_cast<double>(i)));
  }
  FakeCard card{};
  QtSound sound({}, {{"question", write_wav(folder, 1, 16, word)}}, output_of(card));
  sound.play(Cue::question, 0);
  EXPECT_TRUE(eventually([&] { return card.highest_peak > 0.1; }));
  EXPECT_THROW(QtSound({}, {{"question", folder.filePath("none.wav").toStdString()}}),
               std::runtime_error);
}

}  // namespace
}  // namespace asperity
