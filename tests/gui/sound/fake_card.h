// A sound card for tests: takes 10 ms of samples every 10 ms until it stands still or is lost.

#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <thread>

#include <QtCore/QIODevice>
#include <QtCore/QTimer>

#include "app/gui/sound/sound_output.h"

namespace asperity {

struct FakeCard {
  FakeCard() = default;
  FakeCard(const FakeCard&) = delete;
  FakeCard& operator=(const FakeCard&) = delete;
  /// Waits for streams that still close.
  ~FakeCard() {
    hangs = false;
    while (users.use_count() > 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  std::shared_ptr<int> users = std::make_shared<int>();  ///< shared with every output of it
  std::atomic<bool> stands_still{false};
  std::atomic<bool> lost{false};
  std::atomic<bool> hangs{false};  ///< while it is opened
  std::atomic<bool> dies{false};   ///< as soon as it is open
  std::atomic<int> left_out{0};    ///< how often it took no samples while it stood still
  std::atomic<int> opened{0};
  std::atomic<int> open{0};       ///< a stream that ends may still close while the next one opens
  std::atomic<double> peak{0.0};  ///< of the last 10 ms
  /// Of all since it was last set to 0: what sounds for a moment may be over when a busy test looks.
  std::atomic<double> highest_peak{0.0};
};

class FakeConsumer final : public SampleConsumer {
 public:
  FakeConsumer(FakeCard& card, QIODevice& samples) : card_(card) {
    ++card_.opened;
    ++card_.open;
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, &samples] {
      if (card_.stands_still) ++card_.left_out;
      if (card_.stands_still || !is_working()) return;
      std::array<char, 480 * 8> bytes{};
      samples.read(bytes.data(), std::ssize(bytes));
      double peak = 0.0;
      for (std::size_t i = 0; i < bytes.size(); i += 4) {
        float value = 0.0F;
        std::memcpy(&value, bytes.data() + i, sizeof(value));
        peak = std::max(peak, std::abs(static_cast<double>(value)));
      }
      card_.highest_peak = std::max(card_.highest_peak.load(), peak);
      card_.peak = peak;
    });
    timer_.start(10);
  }
  ~FakeConsumer() override { --card_.open; }
  bool is_working() const override { return !card_.lost && !card_.dies; }

 private:
  FakeCard& card_;
  QTimer timer_{};
};

inline SoundOutput output_of(FakeCard& card) {
  SoundOutput output{};
  output.name = "Headphones";
  output.is_null = false;
  output.buffer_s = 0.02;
  output.open = [&card, user = card.users](QIODevice& samples) -> std::unique_ptr<SampleConsumer> {
    while (card.hangs) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (card.lost) return nullptr;
    return std::make_unique<FakeConsumer>(card, samples);
  };
  return output;
}

}  // namespace asperity
