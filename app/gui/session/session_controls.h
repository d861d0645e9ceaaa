// The buttons of a running session, each with its key, and why one of them can not be pressed now.

#pragma once

#include <optional>

#include <QtWidgets/QWidget>

#include "app/conductor/session_requests.h"
#include "app/gui/session/session_keys.h"

class QLabel;
class QPushButton;

namespace asperity {

/// What the buttons depend on.
struct ControlState {
  bool running = false;  ///< begun, and not ended
  bool paused = false;
  bool pause_pending = false;
  std::optional<StopAfter> stop_pending{};
  bool repeat_pending = false;
  bool trial_done = false;  ///< there is one to be repeated
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

 signals:
  void wanted(asperity::SessionVerb verb);
  void skip_wanted();
  /// At the press, not the release.
  void emergency();

 private:
  QPushButton* add(const QString& name);
  void write();

  ControlState state_{};
  QPushButton* pause_ = nullptr;
  QPushButton* stop_trial_ = nullptr;
  QPushButton* stop_block_ = nullptr;
  QPushButton* repeat_ = nullptr;
  QPushButton* skip_ = nullptr;
  QPushButton* note_ = nullptr;
  QPushButton* abort_ = nullptr;
  QPushButton* emergency_ = nullptr;
  QLabel* reason_ = nullptr;
};

}  // namespace asperity
