// The buttons of a running session, each with its key, and why one of them can not be pressed now.

#pragma once

#include <optional>

#include <QtWidgets/QWidget>

#include "app/gui/base/session_keys.h"
#include "app/gui/session/session_form.h"
#include "app/session/session_requests.h"

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace asperity {

/// What the buttons depend on.
struct ControlState {
  bool running = false;     ///< begun, and not ended
  bool preparing = false;   ///< not begun yet
  bool cancelling = false;  ///< and it will not
  bool only_tried = false;  ///< nothing is stored
  bool paused = false;
  bool pause_pending = false;
  std::optional<StopAfter> stop_pending{};
  bool repeat_pending = false;
  bool trial_done = false;  ///< there is one to be repeated
  bool refreshing = false;  ///< practice is repeated, which does not count
  bool in_trial = false;    ///< there is one to be skipped
  bool in_fault = false;
  bool note_locked = false;
  bool operator==(const ControlState&) const = default;
};

class SessionControls final : public QWidget {
  Q_OBJECT
 public:
  explicit SessionControls(QWidget* parent = nullptr);
  void show_state(const ControlState& state);
  void set_form(SessionForm form);
  /// Whether there is one that can be brought back.
  void set_participant_window(bool there);

 signals:
  void wanted(asperity::SessionVerb verb);
  void skip_wanted();

 private:
  QPushButton* add(const QString& name);
  void write();

  ControlState state_{};
  QHBoxLayout* upper_ = nullptr;
  QHBoxLayout* lower_ = nullptr;  ///< empty where one row is enough
  QPushButton* pause_ = nullptr;
  QPushButton* stop_trial_ = nullptr;
  QPushButton* stop_block_ = nullptr;
  QPushButton* repeat_ = nullptr;
  QPushButton* skip_ = nullptr;
  QPushButton* note_ = nullptr;
  QPushButton* abort_ = nullptr;
  QPushButton* their_window_ = nullptr;
  QLabel* reason_ = nullptr;
};

}  // namespace asperity
