// The experimenter's window while a session runs.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include <QtCore/QElapsedTimer>
#include <QtCore/QPointer>
#include <QtWidgets/QDialog>
#include <QtWidgets/QWidget>

#include "app/conductor/conductor.h"
#include "app/conductor/session_monitor.h"
#include "app/conductor/session_requests.h"
#include "app/gui/session/session_keys.h"
#include "app/gui/session/session_text.h"

class QLabel;
class QLayout;
class QProgressBar;
class QPushButton;
class QScreen;
class QStackedWidget;
class QVBoxLayout;

namespace asperity {

class AnswersPanel;
class Banner;
class EndSummary;
class FaultPanel;
class HealthLine;
class LivePlots;
class ModeBand;
class NotesPanel;
class PlanTable;
class ReasonForm;
class SessionControls;
class StateLabel;

/// Shows what the monitor says, sixty times a second, and passes on what the experimenter asks for.
///
/// Double-blind in a run: conditions are codes, the force is the pressing force, and names are taken
/// out of every text that comes from elsewhere, until the experimenter says why they need to know;
/// that is stored, and stays marked. Whether an answer was right is hidden as well, but in blocks
/// whose participant is told too. In pilots and simulations a switch shows the names.
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
  /// False while a session is under way; the question what to do with it is then open.
  bool may_close();
  bool is_blind() const noexcept { return blind_; }

 public slots:
  /// One frame: what the timer does.
  void refresh();
  /// How it ended, where that is known; otherwise the counts of the monitor decide what is said.
  void show_end(const asperity::SessionEnd& end);
  /// Where the participant's screen was unplugged, and the session was asked to pause.
  void tell_screen_lost(const QString& name);
  /// The session could not begin, or broke off: says so, and lets the window close.
  void show_failure(const QString& what);

 signals:
  void closed();
  void results_wanted();
  void trials_wanted();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLayout* make_header();
  QLayout* make_now_line();
  QWidget* make_middle();
  void do_verb(SessionVerb verb);
  void do_emergency_stop();
  void take_keyboard();
  void ask_repeat();
  void ask_skip();
  void ask_abort();
  void ask_unblind();
  void ask_close();
  void blind_again();
  void write_blindness();
  void write_title();
  QString field_lock() const;

  void take_facts(std::shared_ptr<const SessionFacts> facts);
  void take_snapshot();
  void write_moving_texts();
  void write_pending();
  void write_controls();
  void write_answers();
  void write_health();
  void write_trouble();
  QString fault_text() const;
  QString veiled(const std::string& text) const;
  void end();
  void screen_left(QScreen* screen);
  bool is_running() const;
  const Trial* trial_now() const;
  std::int64_t now_ns() const;
  QString clock_text(std::int64_t time_ns) const;

  SessionMonitor& monitor_;
  SessionRequests& requests_;
  std::filesystem::path study_{};

  SessionSnapshot shown_{};
  bool has_shown_ = false;
  std::shared_ptr<const SessionFacts> facts_{};
  NameVeil veil_{};
  bool blind_ = true;
  QString unblinded_at_{};  ///< when names were first shown in a run
  bool own_keyboard_ = false;
  bool ended_ = false;
  bool failed_ = false;
  bool close_when_ended_ = false;
  bool closed_ = false;
  std::optional<SessionEnd> end_{};
  QString stopped_at_{};            ///< when the emergency stop was pressed, until it is cleared
  bool stop_is_confirmed_ = false;  ///< the monitor has shown a fault since
  bool clearing_ = false;           ///< going on was asked for and has not happened yet
  std::int64_t cleared_trouble_ns_ = 0;  ///< a later one is another
  QElapsedTimer since_clearing_{};
  QElapsedTimer since_health_{};
  std::optional<SessionTrouble> trouble_shown_{};
  int explored_trial_ = -1;

  ModeBand* band_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* blindness_ = nullptr;
  QPushButton* unblind_ = nullptr;
  QLabel* block_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* trial_ = nullptr;
  QLabel* elapsed_ = nullptr;
  QLabel* left_ = nullptr;
  QLabel* now_ = nullptr;
  StateLabel* pending_ = nullptr;
  FaultPanel* fault_ = nullptr;
  Banner* trouble_ = nullptr;
  Banner* news_ = nullptr;
  ReasonForm* reason_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  PlanTable* plan_ = nullptr;
  LivePlots* plots_ = nullptr;
  QVBoxLayout* mirror_place_ = nullptr;
  QWidget* mirror_ = nullptr;
  AnswersPanel* answers_ = nullptr;
  NotesPanel* notes_ = nullptr;
  EndSummary* summary_ = nullptr;
  HealthLine* health_ = nullptr;
  SessionControls* controls_ = nullptr;
  SessionKeys* keys_ = nullptr;
  QPointer<QDialog> dialog_{};
};

}  // namespace asperity
