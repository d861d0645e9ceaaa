// Runs the work on a thread with a stop token, and delivers progress and result to the GUI thread.

#include "app/gui/look/background_task.h"

#include <exception>

#include <QtCore/QMetaObject>
#include <QtCore/QPointer>

#include "app/gui/look/words.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

BackgroundTask::BackgroundTask(QObject* parent) : QObject(parent) {}

BackgroundTask::~BackgroundTask() {
  // A worker may be posting to this object: all have to end first, and none waits for another.
  cancel();
  workers_.clear();
}

void BackgroundTask::cancel() {
  for (auto& [number, worker] : workers_) worker.request_stop();
}

void BackgroundTask::abandon() {
  if (!running_) return;
  cancel();
  ++number_;  // nobody waits for the old one
  running_ = false;
  emit finished();
}

void BackgroundTask::begin(std::function<void(const std::stop_token&, const Progress&)> work,
                           std::function<void()> done, std::function<void(QString)> failed) {
  cancel();
  const std::uint64_t number = ++number_;
  running_ = true;
  emit started();
  workers_[number] = std::jthread([this, number, work = std::move(work), done = std::move(done),
                                   failed = std::move(failed)](const std::stop_token& stop) {
    const Progress progress = [this, number](double fraction) {
      QMetaObject::invokeMethod(
          this,
          [this, number, fraction] {
            if (number == number_) emit progressed(fraction);
          },
          Qt::QueuedConnection);
    };
    std::function<void()> deliver = done;
    try {
      work(stop, progress);
    } catch (const std::exception& error) {
      deliver = [failed, what = words_of(phrase_of(error))] { failed(what); };
    }
    QMetaObject::invokeMethod(
        this,
        [this, number, deliver] {
          workers_.erase(number);  // it has nothing left to do
          if (number != number_) return;
          running_ = false;
          // What it is delivered to may be the owner of this task, and end both.
          const QPointer<BackgroundTask> alive(this);
          deliver();
          if (alive) emit finished();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace asperity

#include "moc_background_task.cpp"
