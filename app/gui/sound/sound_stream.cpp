// Opens and watches the output on a worker thread, and reopens it after a loss.

#include "app/gui/sound/sound_stream.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <mutex>
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

/// Streams that are gone while their outputs still close.
std::atomic<int> closing{0};

/// Before the application's object is gone, which sound servers may still want.
void wait_for_closing() {
  const auto latest =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(SoundStream::kCloses_s);
  while (closing > 0 && std::chrono::steady_clock::now() < latest) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

struct SoundStream::Worker {
  SoundOutput output{};
  std::mutex filling{};
  Fill fill{};                           ///< under `filling`; null once the stream is gone
  std::atomic<std::int64_t> last_ns{0};  ///< when samples were last taken; 0: not since it was open
  std::atomic<bool> is_refused{false};
  std::promise<void> first_taken{};
  std::shared_future<void> begun = first_taken.get_future().share();

  std::mutex leaving{};
  bool leave = false;          ///< under `leaving`
  QEventLoop* loop = nullptr;  ///< under `leaving`

  void run();
  void open_if_closed(QIODevice& samples, std::unique_ptr<SampleConsumer>& consumer);
  bool has_to_leave() {
    const std::lock_guard lock(leaving);
    return leave;
  }
};

namespace {

/// What a consumer reads from: never empty, filled as it is read.
template <class Worker>
class SampleDevice final : public QIODevice {
 public:
  explicit SampleDevice(Worker& worker) : worker_(worker) {
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
  }

  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override { return std::int64_t{1} << 30; }

 protected:
  qint64 readData(char* bytes, qint64 most) override {
    const SampleForm& form = worker_.output.form;
    const qint64 frame = form.bytes_per_frame();
    const qint64 frames = most / frame;
    for (qint64 done = 0; done < frames;) {
      const auto part = std::min<qint64>(frames - done, std::ssize(stereo_) / 2);
      const std::span<float> now(stereo_.data(), static_cast<std::size_t>(2 * part));
      {
        // Nobody else wants it until the stream goes.
        const std::lock_guard lock(worker_.filling);
        if (worker_.fill) {
          worker_.fill(now);
        } else {
          std::fill(now.begin(), now.end(), 0.0F);
        }
      }
      write_frames(form, now, bytes + done * frame);
      done += part;
    }
    // An open card says nothing: it may be dead. What it takes is played.
    worker_.last_ns.store(steady_ns(), std::memory_order_relaxed);
    worker_.is_refused = false;
    if (!std::exchange(has_begun_, true)) worker_.first_taken.set_value();
    return frames * frame;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  Worker& worker_;
  std::array<float, 1024> stereo_{};
  bool has_begun_ = false;
};

}  // namespace

void SoundStream::Worker::open_if_closed(QIODevice& samples,
                                         std::unique_ptr<SampleConsumer>& consumer) {
  if (consumer && consumer->is_working()) return;
  if (consumer) {
    last_ns = 0;
    is_refused = true;
    consumer.reset();
    return;  // opened at the next look: a loss is to be seen however short it is
  }
  consumer = output.open(samples);
  if (!consumer) is_refused = true;
}

void SoundStream::Worker::run() {
  QEventLoop events{};
  {
    const std::lock_guard lock(leaving);
    loop = &events;
  }
  SampleDevice<Worker> samples(*this);
  std::unique_ptr<SampleConsumer> consumer{};
  open_if_closed(samples, consumer);
  QTimer watch{};
  QObject::connect(&watch, &QTimer::timeout, &watch, [&] { open_if_closed(samples, consumer); });
  watch.start(kWatch_ms);
  if (!has_to_leave()) events.exec();
  consumer.reset();
  const std::lock_guard lock(leaving);
  loop = nullptr;
}

SoundStream::SoundStream(SoundOutput output, Fill fill) : worker_(std::make_shared<Worker>()) {
  worker_->output = std::move(output);
  worker_->fill = std::move(fill);
  static const bool is_waited_for = (qAddPostRoutine(wait_for_closing), true);
  static_cast<void>(is_waited_for);
  std::thread([worker = worker_]() mutable {
    worker->run();
    worker.reset();
    --closing;
  }).detach();
}

SoundStream::~SoundStream() {
  {
    const std::lock_guard lock(worker_->filling);
    worker_->fill = nullptr;
  }
  ++closing;
  const std::lock_guard lock(worker_->leaving);
  worker_->leave = true;
  // Posted, so that it cannot come before the loop runs.
  if (worker_->loop != nullptr) {
    QCoreApplication::postEvent(worker_->loop, new QEvent(QEvent::Quit));
  }
}

const SoundOutput& SoundStream::output() const noexcept { return worker_->output; }

bool SoundStream::is_running() const noexcept {
  const std::int64_t last_ns = worker_->last_ns.load(std::memory_order_relaxed);
  return last_ns != 0 && static_cast<double>(steady_ns() - last_ns) < kStandsStill_s * 1e9;
}

bool SoundStream::is_refused() const noexcept { return worker_->is_refused; }

bool SoundStream::wait_until_begun(double longest_s) const {
  return worker_->begun.wait_for(std::chrono::duration<double>(longest_s)) ==
         std::future_status::ready;
}

}  // namespace asperity
