// Runs the measurement in a background task; question, answer and motion are exchanged under a mutex.

#include "app/gui/devices/device_test_run.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include <QtCore/QMetaObject>

#include "app/device_bench/device_bench.h"

namespace asperity {

/// What both threads reach.
struct DeviceTestRun::Talk {
  std::mutex mutex{};
  std::condition_variable_any answered{};
  std::optional<bool> answer{};
  bool unanswered = false;  ///< because of the stop
  MotionBins motion{};

  /// Of the question that `ask` puts, and of no other; false also where the work is to stop.
  bool answer_to(const std::function<void()>& ask, const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    answer.reset();
    ask();
    answered.wait(lock, stop, [this] { return answer.has_value(); });
    unanswered = stop.stop_requested();
    return !unanswered && *answer;
  }
};

struct DeviceTestRun::Outcome {
  std::optional<MeasuredDevice> measured{};  ///< unless it was stopped
  QString last_words{};                      ///< of a driver, where that was while its device moved
};

DeviceTestRun::DeviceTestRun(QObject* parent) : QObject(parent), talk_(std::make_shared<Talk>()) {}

// The task, which is the last member, is stopped and waited for first.
DeviceTestRun::~DeviceTestRun() = default;

void DeviceTestRun::begin(const DriverRegistry& drivers, const DriverOptions& options,
                          const std::string& device, const MeasureOrder& order) {
  talk_ = std::make_shared<Talk>();
  // The thread is waited for before this goes; what it says is heard on the GUI thread.
  const auto say = [this](auto signal) {
    QMetaObject::invokeMethod(this, std::move(signal), Qt::QueuedConnection);
  };
  task_.run<Outcome>(
      [this, say, talk = talk_, drivers, options, device, order](
          const std::stop_token& stop, const BackgroundTask::Progress&) -> Outcome {
        try {
          std::optional<MeasuringLock> measuring{};
          if (order.study) measuring.emplace(*order.study);
          VirtualHand hand = hand_to_measure();
          DriverOptions mine = options;
          mine.hand = &hand;
          mine.stop = stop;
          mine.tell = [this, say](const std::string& sentence) {
            say([this, sentence] { emit wished(QString::fromStdString(sentence)); });
          };
          mine.may_move = [this, say, talk, stop](const std::string& sentence) {
            return talk->answer_to(
                [&] { say([this, sentence] { emit asked(QString::fromStdString(sentence)); }); },
                stop);
          };
          std::unique_ptr<HapticDevice> opened_device = drivers.open(device, mine);
          say([this, capability = opened_device->capability()] { emit opened(capability); });
          MeasureOrder told = order;
          told.test.tell = [this, say, talk](const DeviceTestNews& news) {
            {
              const std::lock_guard lock(talk->mutex);
              talk->motion.begin_stage(news.part);
            }
            say([this, news] { emit came_to(news); });
          };
          told.test.watch = [talk](std::span<const TickRecord> ticks) {
            const std::lock_guard lock(talk->mutex);
            talk->motion.add(ticks);
          };
          try {
            return {.measured = measure_device(*opened_device, told, stop)};
          } catch (const DriverHangs&) {
            [[maybe_unused]] HapticDevice* const left = opened_device.release();
            throw;
          }
        } catch (const DeviceStageStopped&) {
          return {};
        } catch (const OpeningStopped& stopped_opening) {
          const std::lock_guard lock(talk->mutex);
          if (!talk->answer.value_or(false)) return {};
          return {.last_words = QString::fromStdString(stopped_opening.what())};
        } catch (const std::exception&) {
          // The driver's refusal, because nobody said yes. Whatever else it tells has to be read: that it cannot
          // let go of an arm, or that the device is gone.
          const std::lock_guard lock(talk->mutex);
          if (talk->unanswered) return {};
          throw;
        }
      },
      [this](const Outcome& outcome) {
        if (outcome.measured) {
          emit measured(*outcome.measured);
        } else {
          emit stopped(outcome.last_words);
        }
      },
      [this](const QString& sentence) { emit failed(sentence); });
}

void DeviceTestRun::stop() { task_.cancel(); }

void DeviceTestRun::answer(bool agreed) {
  const std::lock_guard lock(talk_->mutex);
  talk_->answer = agreed;
  talk_->answered.notify_all();
}

std::vector<MotionBin> DeviceTestRun::take_motion() {
  const std::lock_guard lock(talk_->mutex);
  return talk_->motion.take();
}

}  // namespace asperity

#include "moc_device_test_run.cpp"
