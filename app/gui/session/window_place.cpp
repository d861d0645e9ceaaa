// Places the window once more when the window manager has reported its frame, for at most two seconds.

#include "app/gui/session/window_place.h"

#include <algorithm>

#include <QtGui/QWindow>
#include <QtWidgets/QWidget>

namespace asperity {

namespace {

// Window managers answer within some tenths of a second; one that has not after two seconds draws no
// frame.
constexpr int kFrameLook_ms = 50;
constexpr int kLooks = 40;

}  // namespace

WindowPlace::WindowPlace(QWidget& window) : QObject(&window), window_(window) {
  timer_.setInterval(kFrameLook_ms);
  connect(&timer_, &QTimer::timeout, this, &WindowPlace::look_again);
}

void WindowPlace::fill(const QRect& place) { begin(place, Wish::fill); }

void WindowPlace::keep_within(const QRect& place) { begin(place, Wish::keep_within); }

void WindowPlace::begin(const QRect& place, Wish wish) {
  place_ = place;
  wish_ = wish;
  known_ = frame();
  put();
  looks_left_ = kLooks;
  if (known_.isNull()) timer_.start();
}

QMargins WindowPlace::frame() const {
  const QWindow* window = window_.windowHandle();
  return window == nullptr || !window_.isVisible() ? QMargins() : window->frameMargins();
}

void WindowPlace::put() {
  // Who covers the whole screen wants it so.
  if (window_.isMaximized() || window_.isFullScreen()) {
    if (wish_ == Wish::keep_within) return;
    window_.showNormal();
  }
  if (wish_ == Wish::fill) {
    window_.setGeometry(place_.marginsRemoved(known_));
    return;
  }
  QRect framed = window_.geometry().marginsAdded(known_);
  framed.setSize(framed.size().boundedTo(place_.size()));
  framed.moveLeft(std::clamp(framed.left(), place_.left(), place_.right() + 1 - framed.width()));
  framed.moveTop(std::clamp(framed.top(), place_.top(), place_.bottom() + 1 - framed.height()));
  const QRect inner = framed.marginsRemoved(known_);
  if (inner != window_.geometry()) window_.setGeometry(inner);
}

void WindowPlace::look_again() {
  --looks_left_;
  const QMargins now = frame();
  if (now != known_) {
    known_ = now;
    put();
  }
  if (!known_.isNull() || looks_left_ <= 0) timer_.stop();
}

}  // namespace asperity

#include "moc_window_place.cpp"
