// A stream of samples towards an output, on a thread of its own.

#pragma once

#include <functional>
#include <memory>
#include <span>

#include "app/gui/sound/sound_output.h"

namespace asperity {

/// Lets an output take samples from `fill` for as long as the stream lives.
///
/// The thread belongs to the stream, so that a busy window does not make the sound stutter, and a
/// sound server that takes its time keeps nobody waiting. While the output takes no samples the
/// stream stands still (`is_running` is false): at the beginning, when it cannot be opened, when it
/// does not answer, when it is dead although it could be opened, and when a card that sounded is
/// lost. It is tried again four times a second and never replaced by another: whoever needs to be
/// heard has to know that they are not.
///
/// Threads: constructor and destructor return at once, whatever the output does. It is closed a little
/// after the stream is gone, and asks `fill` for nothing in that time. The destructor of the
/// application's object waits for what still closes, `kCloses_s` at most: an output that hangs is left
/// to itself. The rest answers at once, from any thread, but for `wait_until_begun`. `fill` is called
/// on the stream's thread and has to be real-time code; it is given stereo frames at the rate of
/// `output().form`.
class SoundStream final {
 public:
  using Fill = std::function<void(std::span<float> stereo)>;
  static constexpr double kStandsStill_s = 0.5;
  static constexpr double kCloses_s = 0.5;
  /// No sound server that works takes longer until it wants its first samples.
  static constexpr double kOpens_s = 3.0;

  SoundStream(SoundOutput output, Fill fill);
  ~SoundStream();
  SoundStream(const SoundStream&) = delete;
  SoundStream& operator=(const SoundStream&) = delete;

  /// As given.
  const SoundOutput& output() const noexcept;
  /// Samples have been taken within the last half second, and the output was not lost since.
  bool is_running() const noexcept;
  /// The output could not be opened or was lost, and no samples have been taken since. One that does
  /// not answer is not known to refuse.
  bool is_refused() const noexcept;
  /// Until samples have been taken for the first time, but no longer than this; whether they have.
  bool wait_until_begun(double longest_s) const;

 private:
  struct Worker;
  std::shared_ptr<Worker> worker_;  ///< with the thread, which outlives the stream
};

}  // namespace asperity
