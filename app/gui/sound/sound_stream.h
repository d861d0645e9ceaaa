// A stream of samples towards an output, on a thread of its own.

#pragma once

#include <functional>
#include <memory>
#include <span>

#include "app/gui/sound/sound_output.h"

namespace asperity {

/// Lets an output take samples from `fill` for as long as the stream lives.
///
/// The thread belongs to the stream, so that a busy window does not make the sound stutter. An output
/// that cannot be opened is replaced by the null output at the beginning, and never later: when a
/// card that sounded is lost, the stream stands still (`is_running` is false) until it is back.
///
/// Threads: the constructor waits until the output is open (tens of milliseconds with a sound
/// server), the destructor until it is closed; the rest answers at once, from any thread. `fill` is
/// called on the stream's thread and has to be real-time code; it is given stereo frames at the rate
/// of `output().form`.
class SoundStream final {
 public:
  using Fill = std::function<void(std::span<float> stereo)>;
  static constexpr double kStandsStill_s = 0.5;

  SoundStream(SoundOutput output, Fill fill);
  ~SoundStream();
  SoundStream(const SoundStream&) = delete;
  SoundStream& operator=(const SoundStream&) = delete;

  /// What is really used: the null output where the given one could not be opened.
  const SoundOutput& output() const noexcept;
  /// Samples have been taken within the last half second.
  bool is_running() const noexcept;

 private:
  struct Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace asperity
