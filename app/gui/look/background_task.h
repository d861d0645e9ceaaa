// Long work away from the GUI thread: with progress, cancellable, its result delivered back.

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <thread>
#include <utility>

#include <QtCore/QObject>
#include <QtCore/QString>

namespace asperity {

/// One piece of work. Belongs to the GUI thread; `work` runs on a thread of its own.
///
/// When the task is destroyed, `work` is asked to stop and waited for, and nothing is delivered any
/// more. `done` and `failed` may destroy the task; `finished` is not emitted then.
class BackgroundTask final : public QObject {
  Q_OBJECT
 public:
  using Progress = std::function<void(double)>;  ///< 0 to 1; callable from the worker

  explicit BackgroundTask(QObject* parent = nullptr);
  ~BackgroundTask() override;

  bool is_running() const noexcept { return running_; }
  /// Asks the work to stop; what it returns is delivered all the same.
  void cancel();
  /// Cancels, and delivers nothing but `finished`, now: for work that only reads. It may go on
  /// until it notices.
  void abandon();

  /// Runs `work`, then one of the two on the GUI thread. Work that still runs is cancelled, and what
  /// comes of it is dropped; it may go on beside the new one until it notices, so that nobody waits:
  /// work that writes is begun only when nothing is running. `failed` gets what an exception says.
  template <class Result>
  void run(std::function<Result(const std::stop_token&, const Progress&)> work,
           std::function<void(Result)> done, std::function<void(QString)> failed) {
    auto result = std::make_shared<std::unique_ptr<Result>>();
    begin(
        [work = std::move(work), result](const std::stop_token& stop, const Progress& progress) {
          *result = std::make_unique<Result>(work(stop, progress));
        },
        [done = std::move(done), result] { done(std::move(**result)); }, std::move(failed));
  }

 signals:
  void progressed(double fraction);
  void started();
  void finished();  ///< after `done` or `failed`

 private:
  void begin(std::function<void(const std::stop_token&, const Progress&)> work,
             std::function<void()> done, std::function<void(QString)> failed);

  std::map<std::uint64_t, std::jthread> workers_{};  ///< by number of the run; the last one counts
  bool running_ = false;
  std::uint64_t number_ = 0;
};

}  // namespace asperity
