// Mixes masking noise and the cues for the participant.

#include "app/session/sound/masking_sound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/sound_signals.h"

namespace asperity {

namespace {

constexpr double kCueOverNoise = 1.5;      // RMS of a cue over that of the noise
constexpr double kPauseAfterCue_s = 0.15;  // two cues in a row are heard as two
constexpr double kRelease_s = 0.010;       // of a cue that is interrupted
constexpr double kGainGlide_s = 0.02;
constexpr double kHighestSpeechPeak = 0.7;

constexpr double kC4_Hz = 261.63, kE4_Hz = 329.63, kG4_Hz = 392.00, kA4_Hz = 440.00,
                 kC5_Hz = 523.25, kE5_Hz = 659.26, kF5_Hz = 698.46, kG5_Hz = 783.99,
                 kC6_Hz = 1046.50, kE6_Hz = 1318.51;

std::vector<SoundTone> pattern_of(Cue cue) {
  switch (cue) {
    case Cue::surface:
      return {{kA4_Hz, kA4_Hz, 0.12, 0.10}};
    case Cue::next:
      return {{kE4_Hz, kE5_Hz, 0.20, 0.0}};
    case Cue::question:
      return {{kC5_Hz, kC5_Hz, 0.15, 0.03}, {kF5_Hz, kF5_Hz, 0.25, 0.0}};
    case Cue::option:
      return {{kC6_Hz, kC6_Hz, 0.09, 0.08}};
    case Cue::accepted:
      return {{kE6_Hz, kE6_Hz, 0.25, 0.0}};
    case Cue::refused:
      return {{110.0, 110.0, 0.35, 0.0, SoundTone::Voice::buzz}};
    case Cue::right:
      return {
          {kC5_Hz, kC5_Hz, 0.10, 0.0}, {kE5_Hz, kE5_Hz, 0.10, 0.0}, {kG5_Hz, kG5_Hz, 0.20, 0.0}};
    case Cue::wrong:
      return {{kG4_Hz, kG4_Hz, 0.15, 0.0}, {277.18, 277.18, 0.30, 0.0}};
    case Cue::rest:
      return {{kE4_Hz, kE4_Hz, 0.45, 0.10}, {kC4_Hz, kC4_Hz, 0.60, 0.0}};
    case Cue::paused:
      return {
          {kE4_Hz, kE4_Hz, 0.15, 0.15}, {kE4_Hz, kE4_Hz, 0.15, 0.15}, {kE4_Hz, kE4_Hz, 0.15, 0.0}};
    case Cue::mask_on:
      return {{880.0, 330.0, 0.80, 0.0}};
    case Cue::mask_off:
      return {{330.0, 880.0, 0.80, 0.0}};
    case Cue::finished:
      return {{kC5_Hz, kC5_Hz, 0.15, 0.0},
              {kE5_Hz, kE5_Hz, 0.15, 0.0},
              {kG5_Hz, kG5_Hz, 0.15, 0.0},
              {kC6_Hz, kC6_Hz, 0.45, 0.0}};
  }
  return {};
}

std::vector<SoundTone> pattern_of(GuideTone tone) {
  constexpr double kLow_Hz = 220.0, kHigh_Hz = 1760.0;
  const auto beep = [](double at_Hz) { return std::vector<SoundTone>{{at_Hz, at_Hz, 0.15, 0.15}}; };
  const auto ticks = [](double at_Hz) {
    return std::vector<SoundTone>{{at_Hz, at_Hz, 0.05, 0.05}, {at_Hz, at_Hz, 0.05, 0.25}};
  };
  switch (tone) {
    case GuideTone::none:
      break;
    case GuideTone::press_more:
      return beep(kLow_Hz);
    case GuideTone::press_less:
      return beep(kHigh_Hz);
    case GuideTone::faster:
      return ticks(kLow_Hz);
    case GuideTone::slower:
      return ticks(kHigh_Hz);
  }
  return {};
}

constexpr std::array kGuideTones = {GuideTone::press_more, GuideTone::press_less, GuideTone::faster,
                                    GuideTone::slower};

constexpr std::array kCues = {
    Cue::surface, Cue::next, Cue::question, Cue::option,  Cue::accepted, Cue::refused, Cue::right,
    Cue::wrong,   Cue::rest, Cue::paused,   Cue::mask_on, Cue::mask_off, Cue::finished};

bool is_numbered(Cue cue) { return cue == Cue::surface || cue == Cue::option; }

void check_gain(double gain) {
  if (!(gain > 0.0 && gain <= MaskingSound::kHighestGain)) {
    throw std::invalid_argument("masking noise: gain is " + number_text(gain) +
                                "; it must be above 0 and at most " +
                                number_text(MaskingSound::kHighestGain) + " of full scale");
  }
}

}  // namespace

std::string cue_name(Cue cue, int number) {
  std::string name = text_of(cue);
  if (is_numbered(cue)) name += "_" + std::to_string(number);
  return name;
}

namespace {

std::string names_of_cues() {
  std::string names{};
  for (const Cue cue : kCues) names += (names.empty() ? "" : ", ") + cue_name(cue, 1);
  return names;
}

}  // namespace

MaskingSound::MaskingSound(const MaskingSoundSettings& settings)
    : kind_(settings.noise.kind),
      rate_Hz_(settings.rate_Hz),
      white_{Random(settings.seed).split("left"), Random(settings.seed).split("right")} {
  check_gain(settings.noise.gain);
  if (!(rate_Hz_ >= 8000.0 && rate_Hz_ <= 192000.0)) {
    throw std::invalid_argument("sound: rate_Hz is " + number_text(rate_Hz_) +
                                "; it must be from 8000 to 192000");
  }
  wanted_gain_ = gain_ = settings.noise.gain;

  for (const Cue cue : kCues) {
    Clip clip{};
    for (const SoundTone& tone : pattern_of(cue)) append_tone(tone, rate_Hz_, clip.samples);
    clips_[text_of(cue)] = std::move(clip);
  }
  for (const GuideTone tone : kGuideTones) {
    for (const SoundTone& part : pattern_of(tone)) {
      append_tone(part, rate_Hz_, guides_.at(static_cast<std::size_t>(tone)));
    }
  }
  for (const auto& [name, recording] : settings.speech) {
    if (std::none_of(kCues.begin(), kCues.end(), [&name = name](Cue cue) {
          return is_numbered(cue) ? name.starts_with(text_of(cue) + std::string("_"))
                                  : name == text_of(cue);
        })) {
      throw std::invalid_argument("sound: there is no cue \"" + name +
                                  "\"; use one of: " + names_of_cues());
    }
    Clip clip{};
    if (recording.rate_Hz > 0.0) {
      clip.samples = resampled(recording.samples, recording.rate_Hz, rate_Hz_);
    }
    double sum = 0.0;
    double peak = 0.0;
    for (const float sample : clip.samples) {
      sum += static_cast<double>(sample) * static_cast<double>(sample);
      peak = std::max(peak, std::abs(static_cast<double>(sample)));
    }
    if (!(peak > 0.0)) {
      throw std::invalid_argument("sound: the recording of the cue \"" + name +
                                  "\" is empty or silent; record it again");
    }
    const double rms = std::sqrt(sum / static_cast<double>(clip.samples.size()));
    for (float& sample : clip.samples)
      sample = static_cast<float>(static_cast<double>(sample) / rms);
    clip.peak = static_cast<float>(peak / rms);
    clips_[name] = std::move(clip);
  }
}

void MaskingSound::set_gain(double gain) {
  check_gain(gain);
  wanted_gain_.store(gain, std::memory_order_relaxed);
}

void MaskingSound::play(Cue cue, int number) {
  assert(!is_numbered(cue) || number >= 1);
  const std::lock_guard lock(callers_);
  const std::size_t put = put_.load(std::memory_order_relaxed);
  if (put - taken_.load(std::memory_order_acquire) == kWaiting) {
    cues_lost_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  Playing wanted{.clip = nullptr, .repeats = 1, .gives_way = cue == Cue::option};
  if (const auto word = clips_.find(cue_name(cue, number)); word != clips_.end()) {
    wanted.clip = &word->second;
  } else {
    wanted.clip = &clips_.find(text_of(cue))->second;
    if (is_numbered(cue)) wanted.repeats = number;
  }
  waiting_[put % kWaiting] = wanted;
  put_.store(put + 1, std::memory_order_release);
}

bool MaskingSound::waits_to_cut_off() const noexcept {
  const std::size_t taken = taken_.load(std::memory_order_relaxed);
  return taken != put_.load(std::memory_order_acquire) && waiting_[taken % kWaiting].gives_way;
}

bool MaskingSound::take(Playing& cue) noexcept {
  const std::size_t taken = taken_.load(std::memory_order_relaxed);
  if (taken == put_.load(std::memory_order_acquire)) return false;
  cue = waiting_[taken % kWaiting];
  taken_.store(taken + 1, std::memory_order_release);
  // Of several options in a row only the last is the current one.
  if (cue.gives_way && waits_to_cut_off()) return take(cue);
  return true;
}

double MaskingSound::cue_sample() noexcept {
  if (playing_.clip == nullptr) {
    if (pause_ > 0) {
      --pause_;
      return 0.0;
    }
    if (!take(playing_)) return 0.0;
    position_ = 0;
    release_ = 1.0;
  }
  const Clip& clip = *playing_.clip;
  double level = kCueOverNoise * gain_;
  if (clip.peak > 0.0F)
    level = std::min(level, kHighestSpeechPeak / static_cast<double>(clip.peak));
  const double sample = level * release_ * static_cast<double>(clip.samples[position_]);
  if (++position_ == clip.samples.size()) {
    position_ = 0;
    if (--playing_.repeats <= 0) {
      playing_.clip = nullptr;
      pause_ = samples_in(kPauseAfterCue_s, rate_Hz_);
    }
  }
  if (release_ < 1.0) {
    release_ -= 1.0 / (kRelease_s * rate_Hz_);
    if (release_ <= 0.0) {
      playing_.clip = nullptr;
      pause_ = 0;
    }
  }
  return sample;
}

double MaskingSound::guide_sample() noexcept {
  const bool has_cue = playing_.clip != nullptr || pause_ > 0;
  const GuideTone wanted =
      has_cue ? GuideTone::none : wanted_guide_.load(std::memory_order_relaxed);
  // A tone that is replaced fades out first, to avoid clicks; the next one has its own fade-in.
  const double step = 1.0 / (kRelease_s * rate_Hz_);
  guide_fade_ = std::min(1.0, guide_fade_ + (guide_ == wanted ? step : -step));
  if (guide_ != wanted && (guide_ == GuideTone::none || guide_fade_ <= 0.0)) {
    guide_ = wanted;
    guide_position_ = 0;
    guide_fade_ = 1.0;
  }
  if (guide_ == GuideTone::none) return 0.0;
  const std::vector<float>& samples = guides_[static_cast<std::size_t>(guide_)];
  const double sample = guide_fade_ * static_cast<double>(samples[guide_position_]);
  if (++guide_position_ == samples.size()) guide_position_ = 0;
  return kCueOverNoise * gain_ * sample;
}

double MaskingSound::noise_sample(std::size_t ear) noexcept {
  const double white = white_[ear].normal();
  return kind_ == MaskingNoise::Kind::pink ? pink_[ear].next(white) : white;
}

void MaskingSound::fill(std::span<float> stereo) noexcept {
  const bool noise_wanted =
      wanted_.load(std::memory_order_relaxed) && kind_ != MaskingNoise::Kind::none;
  const double wanted_gain = wanted_gain_.load(std::memory_order_relaxed);
  const double fade_step = (noise_wanted ? 1.0 : -1.0) / (kFade_s * rate_Hz_);
  const double glide = 1.0 / (kGainGlide_s * rate_Hz_);
  // The participant steps through the options: the cue of an earlier one is interrupted.
  if (playing_.clip != nullptr && playing_.gives_way && release_ == 1.0 && waits_to_cut_off()) {
    release_ -= 1.0 / (kRelease_s * rate_Hz_);
  }
  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
    gain_ += (wanted_gain - gain_) * glide;
    fade_ = std::clamp(fade_ + fade_step, 0.0, 1.0);
    double cue = cue_sample();
    cue += guide_sample();
    double loud = 0.0;
    if (fade_ > 0.0) {
      const double sine = std::sin(0.5 * std::numbers::pi * fade_);
      loud = gain_ * sine * sine;
    }
    for (std::size_t ear = 0; ear < 2; ++ear) {
      const double noise = loud > 0.0 ? loud * noise_sample(ear) : 0.0;
      stereo[i + ear] = static_cast<float>(compressed_peak(noise + cue));
    }
  }
}

}  // namespace asperity
