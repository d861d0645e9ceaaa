// Where sound can go: a sound card, or nowhere at the same pace.

#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <QtCore/QString>

class QIODevice;

namespace asperity {

/// How an output takes its samples.
struct SampleForm {
  enum class Type { int16, int32, float32 };
  int rate_Hz = 48000;
  int channels = 2;
  Type type = Type::float32;

  int bytes_per_frame() const noexcept;
};

/// Writes stereo frames as an output takes them: one channel gets the mean of both ears, channels
/// beyond two silence. `bytes` holds as many frames as `stereo`. Real-time: no allocation.
void write_frames(const SampleForm& form, std::span<const float> stereo, char* bytes) noexcept;

/// What takes samples from a device for as long as it lives, at the pace of a sound card or a clock.
/// Made, used and destroyed on one thread, which has an event loop.
class SampleConsumer {
 public:
  virtual ~SampleConsumer() = default;
  SampleConsumer(const SampleConsumer&) = delete;
  SampleConsumer& operator=(const SampleConsumer&) = delete;
  /// False once the card is gone: the consumer is then destroyed, and another one made when the
  /// card is back.
  virtual bool is_working() const = 0;

 protected:
  SampleConsumer() = default;
};

/// An output that can be opened.
struct SoundOutput {
  QString name{};
  bool is_null = true;  ///< nobody hears it
  SampleForm form{};
  double buffer_s = 0.0;  ///< how long a sample waits before it sounds, about
  /// Null where the output cannot be opened now. Called on the thread that is to consume; takes as
  /// long as the sound server does.
  std::function<std::unique_ptr<SampleConsumer>(QIODevice& samples)> open{};
};

/// Takes samples at `rate_Hz` and drops them.
SoundOutput null_output(int rate_Hz = 48000);
/// The system's default output, or the null output where there is no sound card. A sound server's
/// stand-in for a missing card ("auto_null") counts as none.
SoundOutput default_output();
/// Names of the sound cards, the default one first; empty where there is none.
std::vector<QString> sound_outputs();

}  // namespace asperity
