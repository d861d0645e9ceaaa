// Mixes masking noise and the cues for the participant into samples for a sound card.

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

#include "analysis/numbers/random.h"
#include "analysis/signals/sound_signals.h"
#include "app/session/sound/sound.h"

namespace asperity {

/// The name of a cue with its number, in a protocol: "surface_3", "option_1", "question", "mask_on".
std::string cue_name(Cue cue, int number);

/// A spoken word that replaces a cue, mono.
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

/// Fills stereo buffers with noise and with the cues mixed into it.
///
/// Noise: Gaussian, drawn by `Random`, independent in both ears: a sound is then masked nearly
/// equally at every interaural phase, which is not the case with identical noise in both ears
/// [Hirsh 1948]. Its RMS is g·f(t): g the gain (full scale 1), f the fade, which rises or falls as
/// sin² in 0.2 s. White is flat, pink is PinkNoise. The samples are identical for the same seed and the
/// same calls between the same samples.
///
/// Cues are identical in both ears, at an RMS of 1.5·g, 3.5 dB above the total noise and far more
/// above its part in the auditory filter around a tone. They differ in number, pitch and movement:
///
///   surface n   n tones, 440 Hz        option n   n tones, 1047 Hz       question   a fourth up
///   next        a short rise           accepted   one bright tone        refused    a low buzz
///   right       three tones upwards    wrong      a tritone down         rest       two long low
///   paused      three equal low tones  mask_on    a long fall            mask_off   a long rise
///   finished    four tones, up and on
///
/// Guiding tones continue until they are changed, at the same RMS, and are silent during a cue and
/// in the pause after it. Below a band they are at 220 Hz, above it at 1760 Hz, three octaves apart
/// and distinct from the cues; for force a beep of 0.15 s every 0.3 s, for speed two ticks of 0.05
/// s. In the auditory filter around it (48 and 215 Hz wide [Glasberg 1990]) a tone is 18 dB or more
/// above the noise, white or pink.
///
/// A recorded word is scaled to the same RMS, or less, so that its peak stays below 0.7 of full
/// scale. Cues are queued; only a new option interrupts the current cue, because a participant who
/// steps through the options has to hear which one is current.
///
/// Headroom: the sum is a compressed_peak, so that nothing clips. Up to a gain of 0.13 a cue in four-sigma noise stays below 0.8; at 0.25, the maximum,
/// noise alone reaches it in one sample of a thousand.
///
/// Errors: the constructor throws std::invalid_argument for a gain that is not in (0, 0.25], a rate
/// that is not in [8000, 192000] Hz, or a recording that is empty, silent or for an unknown cue.
///
/// Threads: `fill` belongs to one thread; everything else may be called from any. Callers of `play`
/// wait for each other, never for `fill`.
///
/// Real-time: `fill` does not allocate, lock or throw.
///
/// [Hirsh 1948] Hirsh: The influence of interaural phase on interaural summation and inhibition.
/// [Glasberg 1990] Glasberg, Moore: Derivation of auditory filter shapes from notched-noise data.
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
  /// `number` counts from 1 where the cue has one. When sixteen cues are queued, a further one is
  /// dropped, and counted.
  void play(Cue cue, int number);
  void set_guide(GuideTone tone) noexcept { wanted_guide_.store(tone, std::memory_order_relaxed); }
  std::uint64_t cues_lost() const noexcept { return cues_lost_.load(std::memory_order_relaxed); }

  /// Writes the next samples, left and right interleaved.
  void fill(std::span<float> stereo) noexcept;

 private:
  /// Mono samples at RMS 1 (over the parts that are not silent), to be played `repeats` times.
  struct Clip {
    std::vector<float> samples{};
    float peak = 0.0F;  ///< of a recorded word
  };
  struct Playing {
    const Clip* clip = nullptr;
    int repeats = 0;
    bool gives_way = false;  ///< is interrupted by a new cue of its kind
  };

  bool waits_to_cut_off() const noexcept;
  bool take(Playing& cue) noexcept;
  double cue_sample() noexcept;
  double guide_sample() noexcept;
  double noise_sample(std::size_t ear) noexcept;

  MaskingNoise::Kind kind_ = MaskingNoise::Kind::none;
  double rate_Hz_ = 48000.0;
  std::map<std::string, Clip, std::less<>> clips_{};  // fixed once constructed
  // by GuideTone, fixed once constructed; the first is empty
  std::array<std::vector<float>, 5> guides_{};

  // The requested state.
  std::atomic<bool> wanted_{false};
  std::atomic<double> wanted_gain_{0.1};
  std::atomic<GuideTone> wanted_guide_{GuideTone::none};
  static constexpr std::size_t kWaiting = 16;
  std::mutex callers_{};  // of `play`
  std::array<Playing, kWaiting> waiting_{};
  std::atomic<std::size_t> put_{0};
  std::atomic<std::size_t> taken_{0};
  std::atomic<std::uint64_t> cues_lost_{0};

  // Used only by the audio thread.
  std::array<Random, 2> white_;
  std::array<PinkNoise, 2> pink_{};
  double gain_ = 0.1;
  double fade_ = 0.0;  ///< 0 silent, 1 full
  Playing playing_{};
  std::size_t position_ = 0;
  GuideTone guide_ = GuideTone::none;  ///< playing, or fading out
  std::size_t guide_position_ = 0;
  double guide_fade_ = 0.0;
  std::size_t pause_ = 0;  ///< samples of silence before the next cue
  double release_ = 1.0;   ///< falls to 0 while a cue is interrupted
};

}  // namespace asperity
