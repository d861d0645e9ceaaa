// Fills a sound stream with the samples of the masking sound, cues and tones, and describes itself as JSON.

#include "app/gui/sound/qt_sound.h"

#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/gui/sound/speech_file.h"

namespace asperity {

namespace {

constexpr std::uint64_t kSeed = 1;  // noise of a known kind; which samples it has does not matter

std::string_view noise_name(MaskingNoise::Kind kind) {
  switch (kind) {
    case MaskingNoise::Kind::none:
      return "none";
    case MaskingNoise::Kind::white:
      return "white";
    case MaskingNoise::Kind::pink:
      return "pink";
  }
  return "";
}

MaskingSoundSettings settings_of(const MaskingNoise& noise,
                                 const std::map<std::string, std::filesystem::path>& speech,
                                 int rate_Hz) {
  MaskingSoundSettings settings{
      .noise = noise, .rate_Hz = static_cast<double>(rate_Hz), .seed = kSeed};
  for (const auto& [cue, file] : speech) settings.speech[cue] = read_speech(file);
  return settings;
}

}  // namespace

QtSound::QtSound(const MaskingNoise& noise,
                 const std::map<std::string, std::filesystem::path>& speech)
    : QtSound(noise, speech, default_output()) {}

QtSound::QtSound(const MaskingNoise& noise,
                 const std::map<std::string, std::filesystem::path>& speech, SoundOutput output)
    : noise_(noise),
      samples_(settings_of(noise, speech, output.form.rate_Hz)),
      stream_(std::move(output), [this](std::span<float> stereo) { samples_.fill(stereo); }) {}

QtSound::~QtSound() = default;

void QtSound::set_masking(bool on) { samples_.set_masking(on); }

void QtSound::play(Cue cue, int number) { samples_.play(cue, number); }

void QtSound::set_guide(GuideTone tone) { samples_.set_guide(tone); }

void QtSound::set_gain(double gain) { samples_.set_gain(gain); }

std::string QtSound::description_json() const {
  const bool has_begun = stream_.wait_until_begun(SoundStream::kOpens_s);
  const double gain = samples_.gain();
  const bool as_measured = gain == noise_.gain;
  const auto level = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  };
  const SoundOutput& output = stream_.output();
  const nlohmann::ordered_json description = {
      {"kind", noise_name(noise_.kind)},
      {"gain", gain},
      {"declared_dBA", level(noise_.declared_dBA)},
      {"measured_dBA", level(as_measured ? noise_.measured_dBA : std::nullopt)},
      {"verified_by", as_measured ? noise_.verified_by : std::string()},
      {"generator", Random::kName},
      {"output", output.name.toStdString()},
      {"heard", !output.is_null && has_begun},
      {"rate_Hz", output.form.rate_Hz},
      {"buffer_s", output.buffer_s},
  };
  return description.dump();
}

}  // namespace asperity
