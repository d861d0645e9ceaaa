// How long the frames of a session's window take, watched from outside.

#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QPointer>

class QWidget;

namespace asperity {

class ParticipantView;
class SessionWindow;

/// Watches all events of the application while it lives.
///
/// A frame of the session window begins when its timer fires and ends when the plots that it moved
/// have been painted and handed to the screen; one of the mirror begins when the timer of the
/// workspace in it fires and ends likewise. Whatever else the thread did in between counts, and so
/// does what the system did instead of running it. Timers that moved nothing make no frame.
///
/// Threads: the GUI's.
class FrameTimes final : public QObject {
  Q_OBJECT
 public:
  struct Seen {
    std::vector<double> frame_s{};
    /// From one firing of the timer to the next, also where nothing had to be drawn: what the thread
    /// was kept from.
    std::vector<double> interval_s{};
  };

  FrameTimes(SessionWindow& window, ParticipantView& mirror);

  const Seen& window() const noexcept { return window_frames_.seen; }
  const Seen& mirror() const noexcept { return mirror_frames_.seen; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Time = std::chrono::steady_clock::time_point;
  struct Frames {
    std::optional<Time> began{};
    std::optional<Time> fired{};
    bool open = false;  ///< the timer fired and nothing was painted since
    bool painted = false;
    Seen seen{};
    void begin();
    void end();
  };

  void note_timer(QObject* watched);
  void note_paint(QObject* watched);
  void paint(QObject* watched, QEvent* event);

  QPointer<QWidget> session_window_{};
  QPointer<QWidget> plots_{};
  QPointer<QWidget> mirror_{};
  bool painting_ = false;
  Frames window_frames_{};
  Frames mirror_frames_{};
};

}  // namespace asperity
