// Runs one work at a time on a thread, and delivers its result only if no newer one has been requested.

#include "app/gui/look/newest_work.h"

#include <exception>
#include <utility>

#include <QtCore/QMetaObject>

#include "app/gui/look/words.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

NewestWork::NewestWork(QObject* parent) : QObject(parent) {
  worker_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

NewestWork::~NewestWork() {
  // The worker may be posting to this object: it has to end first.
  worker_.request_stop();
  worker_.join();
}

void NewestWork::ask(Work work, std::function<void(QString)> failed) {
  ++asked_;
  {
    const std::lock_guard lock(mutex_);
    waiting_ = Request{asked_, std::move(work), std::move(failed)};
  }
  wake_.notify_one();
}

void NewestWork::run(const std::stop_token& stop) {
  while (true) {
    Request request{};
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
      if (stop.stop_requested()) return;
      request = std::move(*waiting_);
      waiting_.reset();
    }
    Delivery delivery{};
    try {
      delivery = request.work();
    } catch (const std::exception& error) {
      delivery = [this, number = request.number, failed = request.failed,
                  what = words_of(phrase_of(error))] {
        if (number == asked_) failed(what);
      };
    }
    QMetaObject::invokeMethod(
        this, [this, number = request.number, delivery] { deliver(number, delivery); },
        Qt::QueuedConnection);
  }
}

void NewestWork::deliver(std::uint64_t number, const Delivery& delivery) {
  delivered_ = number;
  delivery();
  if (!is_busy()) emit settled();
}

}  // namespace asperity

#include "moc_newest_work.cpp"
