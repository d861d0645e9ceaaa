// A session on a thread of its own, for windows that watch it.

#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include <QtCore/QMetaType>
#include <QtCore/QObject>
#include <QtCore/QString>

#include "app/gui/session/bad_moments.h"
#include "app/session/respondents/person_at_window.h"
#include "app/session/session_monitor.h"
#include "app/session/session_requests.h"
#include "app/session/sound/sound.h"
#include "app/tasks/run_session.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"

namespace asperity {

class MouseTrial;

/// A session as it was decided before it starts.
struct SessionOrder {
  RunInputs inputs{};
  MaskingNoise noise{};
  /// The participant answers on a keyboard of their own or by the device's buttons: text fields of
  /// the experimenter stay usable while a response is open.
  bool own_keyboard = false;
  QString participant_screen{};  ///< its name; empty: both windows on one screen
  /// Recorded cues of the protocol: by cue, the file.
  std::map<std::string, std::filesystem::path> speech{};
  /// Who saw the participant agree; stored among the session's events. Empty: nobody has to say.
  std::string consent_seen_by{};
  /// Of the protocol as it was checked. Empty: whatever the file says when the session starts.
  std::string protocol_sha256{};
  /// The temporary study of the session, which ends after two trials; kept as long as the runner. Null: the open study.
  std::shared_ptr<const MouseTrial> mouse_trial{};
};

/// Makes what a session sounds through, on the session's thread; null: nothing sounds. What it throws
/// ends the session before it begins, with the text as the reason.
using SoundMaker = std::function<std::unique_ptr<Sound>(const SessionOrder&)>;
/// The computer's sound card for a person; virtual participants hear nothing.
std::unique_ptr<Sound> usual_sound(const SessionOrder& order);

/// Runs one session, and only one: what watches it holds references into this object.
///
/// Whatever goes wrong is reported, never thrown: `failed` says what happened, what is safe and what
/// to do; the monitor then shows the phase `ended` with its trouble.
///
/// Threads: belongs to the GUI thread, where all signals come. The session has a thread of its own;
/// the monitor, the requests and `PersonAtWindow::post` may be used from any thread.
///
/// Destroying it aborts a session under way (completed trials are stored, and the session can be
/// resumed) and waits for its end.
class SessionRunner final : public QObject {
  Q_OBJECT
 public:
  explicit SessionRunner(QObject* parent = nullptr, SoundMaker make_sound = usual_sound,
                         DriverRegistry drivers = built_in_drivers(),
                         ModelRegistry models = built_in_models());
  ~SessionRunner() override;

  /// Once in the life of this object.
  void start(const SessionOrder& order);
  /// Of a session that has not begun: it does not. Of one that has, after the trial under way.
  void cancel() { worker_.request_stop(); }
  /// From `start` until `ended` or `failed`.
  bool is_running() const noexcept { return running_; }

  SessionMonitor& monitor() noexcept { return monitor_; }
  SessionRequests& requests() noexcept { return requests_; }
  /// Only after `start`.
  PersonAtWindow& person() noexcept;
  /// Where the participant's window puts its pointer, for the device "mouse"; one thread writes.
  LatestValue<PointerSample>& pointer() noexcept { return pointer_; }
  /// As started.
  const SessionOrder& order() const noexcept { return order_; }

 signals:
  /// What a person has to do for the device while it is opened, a sentence.
  void told(const QString& sentence);
  /// At least one more attempt is on disk; several that come quickly are announced together.
  void attempt_done();
  void ended(const asperity::SessionEnd& end);
  void failed(const QString& text, asperity::AfterFailure next);

 private:
  void run(const std::stop_token& stop);
  void announce_attempt();
  /// `unbegun`: what helps where nothing has begun.
  void fail(const Phrase& what, AfterFailure unbegun);

  SoundMaker make_sound_{};
  DriverRegistry drivers_{};
  LatestValue<PointerSample> pointer_{};
  SessionOrder order_{};
  ModelRegistry models_{};
  SessionMonitor monitor_{};
  SessionRequests requests_{};
  std::unique_ptr<Sound> sound_{};
  std::unique_ptr<PersonAtWindow> person_{};
  bool running_ = false;
  std::atomic<int> attempts_{0};
  std::atomic<bool> announced_{false};  ///< an announcement is on its way
  std::jthread worker_{};
};

}  // namespace asperity
