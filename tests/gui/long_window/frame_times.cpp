// Measures from the timer to the end of painting by an event filter.

#include "tests/gui/long_window/frame_times.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtCore/QTimer>

#include "app/gui/participant/live_workspace.h"
#include "app/gui/participant/participant_view.h"
#include "app/gui/session/live_plots.h"
#include "app/gui/session/session_window.h"

namespace asperity {

namespace {

double elapsed_s(std::chrono::steady_clock::time_point from,
                 std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

FrameTimes::FrameTimes(SessionWindow& window, ParticipantView& mirror)
    : session_window_(&window), plots_(window.findChild<LivePlots*>()), mirror_(&mirror) {
  QCoreApplication::instance()->installEventFilter(this);
}

void FrameTimes::Frames::begin() {
  const Time now = std::chrono::steady_clock::now();
  if (fired) seen.interval_s.push_back(elapsed_s(*fired, now));
  fired = now;
  open = true;
}

void FrameTimes::Frames::end() {
  if (painted && open) {
    seen.frame_s.push_back(elapsed_s(*fired, std::chrono::steady_clock::now()));
    open = false;
  }
  painted = false;
}

bool FrameTimes::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Timer:
      note_timer(watched);
      return false;
    case QEvent::Paint:
      note_paint(watched);
      return false;
    case QEvent::UpdateRequest:
      if (painting_ || watched != session_window_) return false;
      paint(watched, event);
      return true;
    default:
      return false;
  }
}

void FrameTimes::note_timer(QObject* watched) {
  if (qobject_cast<QTimer*>(watched) == nullptr) return;
  const QObject* owner = watched->parent();
  if (owner == session_window_) window_frames_.begin();
  if (qobject_cast<const LiveWorkspace*>(owner) != nullptr) mirror_frames_.begin();
}

void FrameTimes::note_paint(QObject* watched) {
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (widget == nullptr) return;
  if (plots_ && plots_->isAncestorOf(widget)) window_frames_.painted = true;
  if (mirror_ && mirror_->isAncestorOf(widget)) mirror_frames_.painted = true;
}

/// Delivers the event from here, which is the way to see its end.
void FrameTimes::paint(QObject* watched, QEvent* event) {
  painting_ = true;
  QCoreApplication::sendEvent(watched, event);
  painting_ = false;
  window_frames_.end();
  mirror_frames_.end();
}

}  // namespace asperity

#include "moc_frame_times.cpp"
