// Forces made audible: what a texture's force sounds like on a loudspeaker.

#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <span>

#include <QtCore/QObject>
#include <QtCore/QString>

#include "app/gui/sound/sound_stream.h"

namespace asperity {

/// Turns force samples that come in bursts into an even stream of audio samples.
///
/// The force is interpolated by Catmull–Rom cubics, freed of its slow part (below 20 Hz: a hand
/// pressing is no sound) and scaled so that `full_scale_N` is half of full scale; louder is bent, not
/// clipped. The stream begins when 50 ms are there and fades out when it runs dry; what is more than
/// a quarter of a second late is left out.
///
/// Threads: `put` and the setter from one thread, `fill` from one other. Real-time: `fill` does not
/// allocate, lock or throw.
class ForceSound final {
 public:
  explicit ForceSound(double rate_Hz) : rate_Hz_(rate_Hz) {}

  /// What finds no place (4 s at 1 kHz) is dropped.
  void put(std::span<const double> force_N, double force_rate_Hz) noexcept;
  void set_full_scale_N(double force_N) noexcept { full_scale_N_ = force_N; }
  void fill(std::span<float> stereo) noexcept;

 private:
  static constexpr std::size_t kKept = 4096;

  double rate_Hz_ = 48000.0;
  std::array<float, kKept> force_N_{};
  std::atomic<std::size_t> put_{0};
  std::atomic<std::size_t> taken_{0};
  std::atomic<double> force_rate_Hz_{1000.0};
  std::atomic<double> full_scale_N_{1.0};

  // The audio thread's.
  bool playing_ = false;
  double place_ = 0.0;  ///< between force samples `taken_` + 1 and `taken_` + 2
  double last_N_ = 0.0;
  double quick_N_ = 0.0;
  double loudness_ = 0.0;
};

/// Plays forces while they come, for whoever designs a texture.
///
/// Threads: one, the GUI's. `play_force` returns at once.
class ForceSpeaker final : public QObject {
  Q_OBJECT
 public:
  explicit ForceSpeaker(QObject* parent = nullptr);
  explicit ForceSpeaker(SoundOutput output, QObject* parent = nullptr);

  /// The next forces, one after another at `rate_Hz`.
  void play_force(std::span<const double> force_N, double rate_Hz);
  /// The force that is played at half of full scale.
  void set_full_scale_N(double force_N) { sound_.set_full_scale_N(force_N); }
  /// As SoundStream: it is heard, or is known not to be.
  bool is_running() const noexcept { return stream_.is_running(); }
  bool is_refused() const noexcept { return stream_.is_refused(); }
  bool is_null() const noexcept { return stream_.output().is_null; }
  QString device_name() const { return stream_.output().name; }

 private:
  ForceSound sound_;
  SoundStream stream_;
};

}  // namespace asperity
