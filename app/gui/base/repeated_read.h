// A page's look into the study: again whenever something has changed, one at a time.

#pragma once

#include <functional>
#include <stop_token>
#include <utility>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QTimer>

#include "app/gui/look/background_task.h"

namespace asperity {

/// Belongs to the GUI thread; reads on a thread of its own. Several wishes at once are one reading.
class RepeatedRead final : public QObject {
  Q_OBJECT
 public:
  template <class Result>
  RepeatedRead(std::function<Result(const std::stop_token&)> read, std::function<void(Result)> done,
               std::function<void(QString)> failed, QObject* parent)
      : QObject(parent) {
    begin_ = [this, read = std::move(read), done = std::move(done), failed = std::move(failed)] {
      task_.run<Result>([read](const std::stop_token& stop,
                               const BackgroundTask::Progress&) { return read(stop); },
                        done, failed);
    };
    timer_.setSingleShot(true);
    timer_.setInterval(kPause_ms);
    connect(&timer_, &QTimer::timeout, this, &RepeatedRead::read);
    connect(&task_, &BackgroundTask::finished, this, [this] {
      if (std::exchange(again_, false)) timer_.start();
    });
  }

  /// Soon: what comes within a moment is one change.
  void want() { timer_.start(); }
  void read() {
    if (task_.is_running()) {
      again_ = true;
    } else {
      begin_();
    }
  }

 private:
  // An editor that saves a file makes several changes of it.
  static constexpr int kPause_ms = 100;

  std::function<void()> begin_{};
  bool again_ = false;
  QTimer timer_{};
  BackgroundTask task_{};
};

}  // namespace asperity
