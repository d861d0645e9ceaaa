// What went wrong in a session, and the button that helps.

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <QtCore/QElapsedTimer>
#include <QtCore/QObject>
#include <QtCore/QString>

#include "app/gui/session/bad_moments.h"
#include "app/gui/session/session_text.h"
#include "app/session/session_monitor.h"
#include "app/session/session_requests.h"

class QVBoxLayout;
class QWidget;

namespace asperity {

class Banner;
class FaultPanel;

/// Four places, each hidden while it has nothing to say: a fault that holds the force at zero, what
/// the session reports otherwise, what the device complains of (until it no longer does), and news of the
/// windows.
///
/// What comes from elsewhere is shown with names taken out while the experimenter is blind.
class SessionTroubles final : public QObject {
  Q_OBJECT
 public:
  /// Adds the places to `rows`; they belong to `parent`, as this does.
  SessionTroubles(SessionRequests& requests, QVBoxLayout& rows, QWidget* parent);

  void set_facts(std::shared_ptr<const SessionFacts> facts);
  void set_blind(bool blind);
  QString veiled(const QString& text) const;

  void show_snapshot(const SessionSnapshot& snapshot);
  /// A moment passes: a fault that is not gone by now was not cleared.
  void look_again();
  /// At the press: the device's answer is awaited.
  void show_emergency();
  bool is_clearing() const noexcept { return clearing_; }
  /// The session is over: its end says the rest.
  void end();

  /// What a person has to do for the device before the session begins; gone when it has.
  void show_told(const QString& sentence);
  void show_failure(const QString& what, AfterFailure next);
  /// Any screen, before it is known whose it was.
  void show_screen_removed(const QString& name);
  void show_participant_screen_lost(const QString& name, ScreenLoss loss);

 signals:
  /// Somebody wants to end the session for it.
  void end_wanted();
  void pause_wanted();
  /// Of a session that failed.
  void way_on_wanted(asperity::AfterFailure way);
  /// Somebody says that it is plugged in again.
  void participant_screen_back(const QString& name);

 private:
  void clear_fault();
  void write();
  void write_device();
  QString fault_text() const;
  QString clock_text(std::int64_t time_ns) const;

  SessionRequests& requests_;
  std::shared_ptr<const SessionFacts> facts_{};
  SessionSnapshot shown_{};
  NameVeil veil_{};
  bool blind_ = true;
  bool ended_ = false;
  QString stopped_at_{};            ///< when the emergency stop was pressed, until it is cleared
  bool stop_is_confirmed_ = false;  ///< the monitor has shown a fault since
  bool clearing_ = false;           ///< going on was asked for and has not happened yet
  std::int64_t cleared_trouble_ns_ = 0;  ///< a later one is another
  QElapsedTimer since_clearing_{};
  bool is_told_ = false;  ///< the news are what the device wants
  std::optional<SessionTrouble> trouble_shown_{};
  FaultPanel* fault_ = nullptr;
  Banner* trouble_ = nullptr;
  Banner* device_ = nullptr;
  std::string device_shown_{};
  Banner* news_ = nullptr;
};

}  // namespace asperity
