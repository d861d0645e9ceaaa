// The participant's window: nothing but their picture, on their screen.

#pragma once

#include <filesystem>
#include <memory>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/gui/participant/participant_view.h"
#include "app/gui/participant/pointer_feed.h"
#include "app/gui/participant/response_keys.h"

class QScreen;
class QTimer;

namespace asperity {

class ModeBand;

/// Frameless, without any way to close it, the mode's band on top of the participant's view. It ends
/// by itself: after the thanks have been seen, or when its owner allows it (`allow_close`) and closes
/// it. Never a dialog in it.
class ParticipantWindow final : public QWidget {
  Q_OBJECT
 public:
  /// How long the thanks stay.
  static constexpr double kThanks_s = 10.0;

  /// `monitor` must outlive the window.
  ParticipantWindow(const SessionMonitor& monitor, std::filesystem::path study,
                    QWidget* parent = nullptr);

  ParticipantView& view() noexcept { return *view_; }
  ResponseKeys& keys() noexcept { return *keys_; }

  /// The mouse or the pen over the view is the probe of the device "mouse" from now on; `samples` outlives
  /// the window.
  void feed(LatestValue<PointerSample>& samples);

  /// Shows the window over the whole of the screen of this name; over the right half of a screen, a
  /// little less of a small one,
  /// where the name is empty (both windows on one screen) or there is only one. A screen that is not
  /// there is lost (`screen_lost`).
  void open_on(const QString& screen);
  bool is_full_screen() const noexcept { return full_screen_; }
  /// Of a window that shares its screen: the rest of the screen, for the experimenter's.
  QRect room_beside() const;
  /// To the place where it was opened, in front of other windows; the keyboard stays where it is.
  void come_back();

  /// From now on `close()` closes.
  void allow_close() { may_close_ = true; }

 signals:
  /// By mouse or by key, whichever window had the focus.
  void acted(asperity::ParticipantInput input);
  /// What is to stand in the session's record: SessionRequests::remark(kind, text).
  void remarked(const QString& kind, const QString& text);
  /// The screen was unplugged; the window is now on the right half of the one that is left.
  void screen_lost(const QString& name);
  void closed();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void follow();
  void cover(QScreen& screen);
  void stand_beside(QScreen& screen);
  void leave_screen(QScreen* screen);

  const SessionMonitor& monitor_;
  ModeBand* band_ = nullptr;
  ParticipantView* view_ = nullptr;
  std::unique_ptr<PointerFeed> feed_{};
  std::unique_ptr<ResponseKeys> keys_{};  // gone before the focus of a dying window moves
  QTimer* thanks_ = nullptr;
  bool asked_for_text_ = false;
  QString screen_name_{};
  bool full_screen_ = false;
  bool may_close_ = false;
};

}  // namespace asperity
