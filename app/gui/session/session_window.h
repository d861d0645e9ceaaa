// The experimenter's window while a session runs.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include <QtCore/QElapsedTimer>
#include <QtWidgets/QWidget>

#include "app/gui/base/session_keys.h"
#include "app/gui/session/bad_moments.h"
#include "app/gui/session/time_left.h"
#include "app/session/conductor.h"
#include "app/session/session_monitor.h"
#include "app/session/session_requests.h"

class QScreen;
class QStackedWidget;

namespace asperity {

class AnswersPanel;
class EndSummary;
class HealthLine;
class LivePlots;
class MirrorFrame;
class ModeBand;
class NotesPanel;
class PlanTable;
class ReasonForm;
class SessionControls;
class SessionHeader;
class SessionParts;
class SessionQuestions;
class SessionTroubles;
class TrackPanel;
class WindowPlace;

/// Shows what the monitor says, sixty times a second, and passes on what the experimenter asks for.
///
/// Double-blind in a run: conditions are codes, the force is the pressing force, and names are taken
/// out of every text that comes from elsewhere, until the experimenter says why they need to know;
/// that is stored, and stays marked. Whether an answer was right is hidden as well, but in blocks
/// whose participant is told too. In pilots and simulations a switch shows the names.
///
/// Its width decides how much stands side by side (session_form.h), down to half of a small screen. No
/// content changes its size.
///
/// Nothing that it opens is modal: the emergency stop can be clicked and heard at any moment.
///
/// Whoever owns the window asks `may_close` before a program ends with it, and destroys it after
/// `closed`. Threads: the GUI's. A frame copies the snapshot and draws what changed.
class SessionWindow final : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive the window.
  SessionWindow(SessionMonitor& monitor, SessionRequests& requests, std::filesystem::path study,
                QWidget* parent = nullptr);
  ~SessionWindow() override;

  /// What the participant sees; the window takes it over.
  void set_mirror(QWidget* mirror);
  /// The participant has keys of their own (a second keyboard, buttons of the device): the fields of
  /// this window stay open while a response is.
  void set_own_keyboard(bool own);
  /// Nothing of the session is stored: it ends without a question.
  void set_only_tried(bool only_tried);
  /// There is a window of the participant's, which can be asked to come back to its place.
  void set_participant_window(bool there);
  /// To be told once; the frame's width is known only after the window is shown (window_place.h).
  WindowPlace& place() noexcept { return *place_; }
  /// False while a session is under way; the question what to do with it is then open.
  bool may_close();
  bool is_blind() const noexcept { return blind_; }

 public slots:
  /// One frame: what the timer does.
  void refresh();
  /// How it ended, where that is known; otherwise the counts of the monitor decide what is said.
  void show_end(const asperity::SessionEnd& end);
  /// What a person has to do for the device while the session is prepared.
  void tell_device_wish(const QString& sentence);
  /// Of the participant; the session has been stopped or asked to pause for it.
  void tell_screen_lost(const QString& name, asperity::ScreenLoss loss);
  /// The session could not begin, or broke off: says so, offers what helps, and lets the window
  /// close.
  void show_failure(const QString& what, asperity::AfterFailure next);

 signals:
  void closed();
  void results_wanted();
  void trials_wanted();
  /// The session has not begun, and is not to.
  void cancel_wanted();
  /// The session has ended, and somebody wants it to be tried or gone on with in this way.
  void way_on_wanted(asperity::AfterFailure way);
  /// The participant's screen is plugged in again: their window is to go back there.
  void participant_screen_back(const QString& name);
  /// Their window is to stand at its place again, in front of others.
  void participant_window_wanted();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_middle();
  void fit_form();
  void connect_parts();
  void do_verb(SessionVerb verb);
  void do_emergency_stop();
  void take_keyboard();
  void change_blindness();
  void write_blindness();
  QString field_lock() const;
  void lock_fields();

  void take_facts(std::shared_ptr<const SessionFacts> facts);
  void take_snapshot();
  void show_exploration();
  void write_moving_texts();
  void write_left();
  void write_pending();
  void write_controls();
  void write_answers();
  void write_tracks();
  void write_health();
  void end();
  void write_end();
  void screen_left(QScreen* screen);
  bool is_running() const;
  bool is_preparing() const;

  SessionMonitor& monitor_;
  SessionRequests& requests_;
  std::filesystem::path study_{};

  SessionSnapshot shown_{};
  bool has_shown_ = false;
  std::shared_ptr<const SessionFacts> facts_{};
  bool blind_ = true;
  QString unblinded_at_{};  ///< when names were first shown in a run
  bool own_keyboard_ = false;
  bool only_tried_ = false;
  bool ended_ = false;
  bool cancelling_ = false;  ///< the preparation
  bool failed_ = false;
  bool close_when_ended_ = false;
  bool closed_ = false;
  std::optional<SessionEnd> end_{};
  QElapsedTimer since_health_{};
  TimeLeft time_left_{};
  int explored_trial_ = -1;
  /// From which the tracks were computed.
  std::shared_ptr<const std::vector<AttemptSummary>> tracked_attempts_{};
  int tracked_block_ = 0;
  int latest_block_ = 0;  ///< the present one; between blocks the last one

  WindowPlace* place_ = nullptr;
  ModeBand* band_ = nullptr;
  SessionHeader* header_ = nullptr;
  SessionTroubles* troubles_ = nullptr;
  ReasonForm* reason_ = nullptr;
  SessionQuestions* questions_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  SessionParts* parts_ = nullptr;
  PlanTable* plan_ = nullptr;
  LivePlots* plots_ = nullptr;
  MirrorFrame* mirror_ = nullptr;
  TrackPanel* tracks_ = nullptr;
  AnswersPanel* answers_ = nullptr;
  NotesPanel* notes_ = nullptr;
  EndSummary* summary_ = nullptr;
  HealthLine* health_ = nullptr;
  SessionControls* controls_ = nullptr;
  SessionKeys* keys_ = nullptr;
};

}  // namespace asperity
