// Where a session comes together: the page before it, its thread, and its two windows.

#pragma once

#include <functional>
#include <memory>

#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtCore/QString>

#include "app/gui/base/session_wish.h"
#include "app/gui/base/stimulus_examiner.h"
#include "app/gui/look/background_task.h"
#include "app/gui/look/controls.h"
#include "app/gui/participant/participant_window.h"
#include "app/gui/session/session_runner.h"
#include "app/gui/session/session_window.h"

namespace asperity {

class BatchSimulation;
class OpenStudy;
class StartPage;
class StudyWindow;

/// Gives the study window its start page, and runs one session at a time from there: the experimenter's
/// window on their screen, the participant's on theirs (none for a simulation: the mirror shows what a
/// person would see). While a session runs, the study window stays usable for reading and cannot be
/// closed.
class SessionDesk final : public QObject {
  Q_OBJECT
 public:
  /// `window` outlives the desk, or is its parent.
  SessionDesk(StudyWindow& window, QObject* parent, SoundMaker make_sound = usual_sound);
  ~SessionDesk() override;

  bool is_running() const;
  /// Null while there is none.
  SessionRunner* runner() const noexcept { return runner_.get(); }
  SessionWindow* session_window() const noexcept { return session_window_; }
  ParticipantWindow* participant_window() const noexcept { return participant_window_; }

 public slots:
  void begin(const asperity::SessionOrder& order);

 private:
  void take_study(OpenStudy& study);
  void choose(const SessionWish& wish);
  void simulate(const SimulationInputs& inputs);
  void try_by_mouse(const SessionWish& wish);
  void end_mouse_trial(State state, const QString& what);
  bool refuse_another();
  void open_participant_window();
  void open_session_window();
  void stop_for_lost_screen(const QString& screen);
  void put_participant_back(const QString& screen);
  void go_on(AfterFailure way);
  /// Shows the page, where one is named, once the session's thread is done, and then does `next`.
  void finish(const QString& page, std::function<void()> next = {});

  StudyWindow& window_;
  SoundMaker make_sound_{};
  BatchSimulation* simulation_ = nullptr;
  OpenStudy* study_ = nullptr;
  std::function<void()> finish_later_{};  ///< the session's window is left, its thread not done yet
  BackgroundTask prepare_task_{};
  QPointer<StartPage> start_page_{};
  StimulusExaminer::Hold hold_{};
  std::unique_ptr<SessionRunner> runner_{};
  QPointer<SessionWindow> session_window_{};
  QPointer<ParticipantWindow> participant_window_{};
};

}  // namespace asperity
