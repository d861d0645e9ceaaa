// Masking noise and signals to the participant, as samples for a sound card.

#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "analysis/random.h"
#include "app/session/sound/sound.h"

namespace asperity {

/// The name of a cue with its number, in a protocol: "surface_3", "option_1", "question", "mask_on".
std::string cue_name(Cue cue, int number);

/// A spoken word that stands for a cue, mono.
struct CueRecording {
  double rate_Hz = 0.0;
  std::vector<float> samples{};
};

struct MaskingSoundSettings {
  MaskingNoise noise{};
  double rate_Hz = 48000.0;
  std::uint64_t seed = 1;
  /// By `cue_name`; a cue without one is a pattern of tones.
  std::map<std::string, CueRecording, std::less<>> speech{};
};

/// Fills stereo buffers with noise and, mixed into it, cues.
///
/// Noise: Gaussian, drawn by `Random`, independent in both ears: whatever the phase at which a sound
/// reaches them, it is masked nearly alike, which it would not be by the same noise in both
/// [Hirsh 1948]. Its RMS is g·f(t): g the gain (full scale 1), f the fade, which rises or falls as
/// sin² in 0.2 s. White is flat; pink is white through a sum of seven first-order filters
/// [Kellett 2000], −3 dB per octave within 0.5 dB from 50 Hz to 8 kHz at 44.1 or 48 kHz. For the
/// same seed and the same calls between the same samples the samples are the same.
///
/// Cues sound in both ears alike at an RMS of 1.5·g, 3.5 dB above all of the noise and far more
/// above its part in the ear's band around a tone. They differ in number, pitch and
/// movement:
///
///   surface n   n tones, 440 Hz        option n   n tones, 1047 Hz       question   a fourth up
///   next        a short rise           accepted   one bright tone        refused    a low buzz
///   right       three tones upwards    wrong      a tritone down         rest       two long low
///   paused      three equal low tones  mask_on    a long fall            mask_off   a long rise
///   finished    four tones, up and on
///
/// Guiding tones go on until they are changed, at the same RMS, and stand back while a cue sounds and in the
/// pause after it. Below a
/// band they are at 220 Hz, above it at 1760 Hz, three octaves apart and away from the cues; of force a
/// beep of 0.15 s every 0.3 s, of speed two ticks of 0.05 s. In the ear's band around it (48 and 215 Hz
/// wide [Glasberg 1990]) a tone is 18 dB or more above the noise, white or pink.
///
/// A recorded word is brought to the same RMS, or less, so that its peak stays below 0.7 of full
/// scale. Cues wait for each other; only a new option cuts the one that sounds off, because a
/// participant who steps through the options has to hear which one is current.
///
/// Headroom: a sum x above 0.8 is bent to 0.8 + 0.2·tanh((x − 0.8)/0.2), so nothing clips. Up to a
/// gain of 0.13 a cue in four-sigma noise stays below it; at 0.25, the highest, noise alone meets it
/// in one sample of a thousand.
///
/// Errors: the constructor throws std::invalid_argument for a gain that is not in (0, 0.25], a rate
/// that is not in [8000, 192000] Hz, a recording that is empty or silent or for no cue there is.
///
/// Threads: `fill` belongs to one thread; everything else may be called from any. Callers of `play`
/// wait for each other, never for `fill`.
///
/// Real-time: `fill` does not allocate, lock or throw.
///
/// [Hirsh 1948] Hirsh: The influence of interaural phase on interaural summation and inhibition.
/// [Glasberg 1990] Glasberg, Moore: Derivation of auditory filter shapes from notched-noise data.
/// [Kellett 2000] Kellett: Filter to make pink noise from white, musicdsp.org.
class MaskingSound final {
 public:
  static constexpr double kFade_s = 0.2;
  static constexpr double kHighestGain = 0.25;

  explicit MaskingSound(const MaskingSoundSettings& settings);
  MaskingSound(const MaskingSound&) = delete;
  MaskingSound& operator=(const MaskingSound&) = delete;

  void set_masking(bool on) noexcept { wanted_.store(on, std::memory_order_relaxed); }
  /// The level of noise and cues together, reached within a tenth of a second. Errors: as the
  /// constructor.
  void set_gain(double gain);
  double gain() const noexcept { return wanted_gain_.load(std::memory_order_relaxed); }
  /// `number` counts from 1 where the cue has one. A cue behind sixteen that wait is lost, and
  /// counted.
  void play(Cue cue, int number);
  void set_guide(GuideTone tone) noexcept { wanted_guide_.store(tone, std::memory_order_relaxed); }
  std::uint64_t cues_lost() const noexcept { return cues_lost_.load(std::memory_order_relaxed); }

  /// The next samples, left and right in turn.
  void fill(std::span<float> stereo) noexcept;

 private:
  /// Mono samples at RMS 1 (over what sounds), to be played `repeats` times.
  struct Clip {
    std::vector<float> samples{};
    float peak = 0.0F;  ///< of a recorded word
  };
  struct Playing {
    const Clip* clip = nullptr;
    int repeats = 0;
    bool gives_way = false;  ///< to a new one of its kind
  };
  struct Pink {
    std::array<double, 7> state{};
    double next(double white) noexcept;
  };

  bool waits_to_cut_off() const noexcept;
  bool take(Playing& cue) noexcept;
  double cue_sample() noexcept;
  double guide_sample() noexcept;
  double noise_sample(std::size_t ear) noexcept;

  MaskingNoise::Kind kind_ = MaskingNoise::Kind::none;
  double rate_Hz_ = 48000.0;
  std::map<std::string, Clip, std::less<>> clips_{};  // fixed once constructed
  std::array<std::vector<float>, 5> guides_{};        // by GuideTone, likewise; the first is empty

  // What is asked for.
  std::atomic<bool> wanted_{false};
  std::atomic<double> wanted_gain_{0.1};
  std::atomic<GuideTone> wanted_guide_{GuideTone::none};
  static constexpr std::size_t kWaiting = 16;
  std::mutex callers_{};  // of `play`
  std::array<Playing, kWaiting> waiting_{};
  std::atomic<std::size_t> put_{0};
  std::atomic<std::size_t> taken_{0};
  std::atomic<std::uint64_t> cues_lost_{0};

  // The audio thread's.
  std::array<Random, 2> white_;
  std::array<Pink, 2> pink_{};
  double pink_scale_ = 1.0;  ///< brings pink to RMS 1
  double gain_ = 0.1;
  double fade_ = 0.0;  ///< 0 silent, 1 full
  Playing playing_{};
  std::size_t position_ = 0;
  GuideTone guide_ = GuideTone::none;  ///< sounding, or fading out
  std::size_t guide_position_ = 0;
  double guide_fade_ = 0.0;
  std::size_t pause_ = 0;  ///< samples of silence before the next cue
  double release_ = 1.0;   ///< falls to 0 while a cue is cut off
};

}  // namespace asperity
