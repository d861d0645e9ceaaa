// The interface of a session to loudspeakers or headphones.

#pragma once

#include <optional>
#include <string>

namespace asperity {

/// A signal to the participant. Its number is that of the surface or option.
enum class Cue {
  surface,   ///< surface `number` can be felt: `number` short tones
  next,      ///< the surface was felt for long enough: lift
  question,  ///< the answer is open
  option,    ///< option `number` is the one that a confirmation would choose
  accepted,
  refused,  ///< not yet: something has to be felt or done first
  right,
  wrong,
  rest,  ///< a break begins or ends
  paused,
  mask_on,
  mask_off,
  finished,
};
/// The instruction of a continuous tone to the hand that feels a surface.
enum class GuideTone {
  none,
  press_more,  ///< a low beep, repeated
  press_less,  ///< a high beep, repeated
  faster,      ///< two low ticks, repeated
  slower,      ///< two high ticks, repeated
};

/// "surface", "mask_on".
const char* text_of(Cue cue) noexcept;

struct MaskingNoise {
  enum class Kind { none, white, pink } kind = Kind::none;
  double gain = 0.1;                     ///< RMS of the noise, full scale 1
  std::optional<double> declared_dBA{};  ///< by the protocol
  std::optional<double> measured_dBA{};  ///< at the ear, by the experimenter
  std::string verified_by{};

  bool is_attested() const noexcept { return measured_dBA && !verified_by.empty(); }
};

/// Plays masking noise and mixes cues into it.
///
/// Threads: any; calls return at once, except `description_json`, which may wait some seconds for a
/// sound card. A session without sound has a null pointer instead.
class Sound {
 public:
  virtual ~Sound() = default;
  Sound(const Sound&) = delete;
  Sound& operator=(const Sound&) = delete;

  /// Fades in or out in 0.2 s.
  virtual void set_masking(bool on) = 0;
  virtual void play(Cue cue, int number) = 0;
  /// Plays until another one is set.
  virtual void set_guide(GuideTone tone) = 0;
  /// Whether samples have been consumed within the last half second. A session that requires its
  /// noise pauses when this becomes false.
  virtual bool is_running() const = 0;
  /// Whether there is a sound card. Without one, samples are consumed as well, and cannot be heard.
  virtual bool is_heard() const = 0;
  /// Whether a person has measured the sound at the ear and confirms it: without a sound card, a
  /// sound that comes from another source.
  virtual bool is_attested() const = 0;
  /// The description that is stored with the session: kind, gain, levels, who verified them, output
  /// device.
  virtual std::string description_json() const = 0;

 protected:
  Sound() = default;
};

}  // namespace asperity
