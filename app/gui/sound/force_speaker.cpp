// Resamples forces from a ring buffer by cubic interpolation, with fades, and removes slow changes.

#include "app/gui/sound/force_speaker.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

constexpr double kBegin_s = 0.05;   // outlasts the pauses between two bursts of a window
constexpr double kLatest_s = 0.25;  // what is later than this is left out
constexpr double kFade_s = 0.01;
constexpr double kSlowest_Hz = 20.0;  // the lower limit of hearing

}  // namespace

void ForceSound::put(std::span<const double> force_N, double force_rate_Hz) noexcept {
  force_rate_Hz_.store(force_rate_Hz, std::memory_order_relaxed);
  const std::size_t put = put_.load(std::memory_order_relaxed);
  const std::size_t room = kKept - (put - taken_.load(std::memory_order_acquire));
  const std::size_t count = std::min(room, force_N.size());
  for (std::size_t i = 0; i < count; ++i)
    force_N_[(put + i) % kKept] = static_cast<float>(force_N[i]);
  put_.store(put + count, std::memory_order_release);
}

void ForceSound::fill(std::span<float> stereo) noexcept {
  const double force_rate_Hz = force_rate_Hz_.load(std::memory_order_relaxed);
  const double scale = 0.5 / full_scale_N_.load(std::memory_order_relaxed);
  const double step = force_rate_Hz / rate_Hz_;
  const double keep = std::exp(-2.0 * std::numbers::pi * kSlowest_Hz / rate_Hz_);
  const std::size_t put = put_.load(std::memory_order_acquire);
  std::size_t taken = taken_.load(std::memory_order_relaxed);
  const auto samples = [force_rate_Hz](double duration_s) {
    return static_cast<std::size_t>(duration_s * force_rate_Hz);
  };
  if (put - taken > samples(kLatest_s)) taken = put - samples(kBegin_s);
  if (!playing_ && put - taken >= samples(kBegin_s)) playing_ = true;

  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
    if (playing_ && put - taken < 4) playing_ = false;
    double force_N = last_N_;
    if (playing_) {
      const auto at = [this, taken](std::size_t k) {
        return static_cast<double>(force_N_[(taken + k) % kKept]);
      };
      const double a = at(0), b = at(1), c = at(2), d = at(3), u = place_;
      force_N =
          b +
          0.5 * u * (c - a + u * (2.0 * a - 5.0 * b + 4.0 * c - d + u * (3.0 * (b - c) + d - a)));
      place_ += step;
      while (place_ >= 1.0 && put - taken >= 4) {
        place_ -= 1.0;
        ++taken;
      }
    }
    quick_N_ = keep * (quick_N_ + force_N - last_N_);
    last_N_ = force_N;
    const double fade = (playing_ ? 1.0 : -1.0) / (kFade_s * rate_Hz_);
    loudness_ = std::clamp(loudness_ + fade, 0.0, 1.0);
    stereo[i] = stereo[i + 1] = static_cast<float>(std::tanh(loudness_ * scale * quick_N_));
  }
  taken_.store(taken, std::memory_order_release);
}

ForceSpeaker::ForceSpeaker(QObject* parent) : ForceSpeaker(default_output(), parent) {}

ForceSpeaker::ForceSpeaker(SoundOutput output, QObject* parent)
    : QObject(parent),
      sound_(static_cast<double>(output.form.rate_Hz)),
      stream_(std::move(output), [this](std::span<float> stereo) { sound_.fill(stereo); }) {}

void ForceSpeaker::play_force(std::span<const double> force_N, double rate_Hz) {
  sound_.put(force_N, rate_Hz);
}

}  // namespace asperity

#include "moc_force_speaker.cpp"
