// The program's application with the longest piece of work of its thread, and the clocks of the process.

#pragma once

#include <ctime>
#include <functional>
#include <string>

#include <QtCore/QEvent>
#include <QtCore/QObject>
#include <QtWidgets/QApplication>

namespace asperity {

inline double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The longest piece of work of one thread: an event with all that it sets off, or a call.
struct LongestWork {
  double cpu_s = 0.0;
  std::string what{};

  void time(const std::function<void()>& work, const std::function<std::string()>& name) {
    const double began_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    work();
    const double took_s = seconds_of(CLOCK_THREAD_CPUTIME_ID) - began_s;
    if (took_s <= cpu_s) return;
    cpu_s = took_s;
    what = name();
  }
};

class TimedApplication final : public QApplication {
 public:
  using QApplication::QApplication;

  LongestWork longest{};

  bool notify(QObject* receiver, QEvent* event) override {
    if (inside_) return QApplication::notify(receiver, event);
    inside_ = true;
    bool done = false;
    // What it is, before: the receiver may be gone afterwards.
    const std::string type = receiver->metaObject()->className();
    const int number = event->type();
    longest.time([&] { done = QApplication::notify(receiver, event); },
                 [&] { return type + ", event " + std::to_string(number); });
    inside_ = false;
    return done;
  }

 private:
  bool inside_ = false;
};

}  // namespace asperity
