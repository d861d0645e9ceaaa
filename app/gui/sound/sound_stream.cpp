#include "app/gui/sound/sound_stream.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <thread>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtCore/QEventLoop>
#include <QtCore/QIODevice>
#include <QtCore/QTimer>

namespace asperity {

namespace {

constexpr int kWatch_ms = 250;

std::int64_t steady_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

/// What a consumer reads from: never empty, filled as it is read.
class SampleDevice final : public QIODevice {
 public:
  SampleDevice(const SoundStream::Fill& fill, std::atomic<std::int64_t>& last_ns)
      : fill_(fill), last_ns_(last_ns) {
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
  }

  void set_form(const SampleForm& form) { form_ = form; }
  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override { return std::int64_t{1} << 30; }

 protected:
  qint64 readData(char* bytes, qint64 most) override {
    const qint64 frame = form_.bytes_per_frame();
    const qint64 frames = most / frame;
    for (qint64 done = 0; done < frames;) {
      const auto part = std::min<qint64>(frames - done, std::ssize(stereo_) / 2);
      const std::span<float> now(stereo_.data(), static_cast<std::size_t>(2 * part));
      fill_(now);
      write_frames(form_, now, bytes + done * frame);
      done += part;
    }
    last_ns_.store(steady_ns(), std::memory_order_relaxed);
    return frames * frame;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  SampleForm form_{};
  const SoundStream::Fill& fill_;
  std::atomic<std::int64_t>& last_ns_;
  std::array<float, 1024> stereo_{};
};

}  // namespace

struct SoundStream::Worker {
  SoundOutput output{};
  Fill fill{};
  std::atomic<std::int64_t> last_ns{0};
  std::promise<QEventLoop*> opened{};
  QEventLoop* loop = nullptr;
  std::thread thread{};

  void run() {
    // First of all: it gives the thread the event dispatcher that timers and sinks need.
    QEventLoop events{};
    SampleDevice samples(fill, last_ns);
    samples.set_form(output.form);
    std::unique_ptr<SampleConsumer> consumer = output.open(samples);
    if (!consumer) {
      output = null_output(output.form.rate_Hz);
      samples.set_form(output.form);
      consumer = output.open(samples);
    }
    QTimer watch{};
    QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
      if (consumer && !consumer->is_working()) consumer.reset();
      if (!consumer) consumer = output.open(samples);
    });
    watch.start(kWatch_ms);
    last_ns.store(steady_ns(), std::memory_order_relaxed);
    opened.set_value(&events);
    events.exec();
  }
};

SoundStream::SoundStream(SoundOutput output, Fill fill) : worker_(std::make_unique<Worker>()) {
  worker_->output = std::move(output);
  worker_->fill = std::move(fill);
  worker_->thread = std::thread([worker = worker_.get()] { worker->run(); });
  worker_->loop = worker_->opened.get_future().get();
}

SoundStream::~SoundStream() {
  // Posted, so that it cannot come before the loop runs.
  QCoreApplication::postEvent(worker_->loop, new QEvent(QEvent::Quit));
  worker_->thread.join();
}

const SoundOutput& SoundStream::output() const noexcept { return worker_->output; }

bool SoundStream::is_running() const noexcept {
  const auto since_ns = steady_ns() - worker_->last_ns.load(std::memory_order_relaxed);
  return static_cast<double>(since_ns) < kStandsStill_s * 1e9;
}

}  // namespace asperity
