// What the values of a session mean, in the words of the experimenter's window.

#pragma once

#include <optional>

#include <QtCore/QCoreApplication>
#include <QtCore/QRegularExpression>
#include <QtCore/QString>

#include "app/gui/look/controls.h"
#include "app/gui/session/bad_moments.h"
#include "app/session/session_monitor.h"

namespace asperity {

/// Takes the names of textures, stimuli and models, and the paths of their files, out of texts that
/// come from elsewhere (why an attempt does not count, what failed), for who is not to know them.
class NameVeil final {
 public:
  NameVeil() = default;
  NameVeil(const Protocol& protocol, const Plan& plan);
  QString veiled(const QString& text) const;

 private:
  QRegularExpression names_{};  // matches nothing while there is no plan
  bool is_set_ = false;
};

class SessionText final {
  Q_DECLARE_TR_FUNCTIONS(SessionText)
 public:
  /// "Trial 17: feeling surface 1 of 2 (S3), 6.2 s". `to_come`: the trial that comes when none is under
  /// way, 0 for none; `in_phase_s`: since the phase began; `condition`: of the surface, as it may be known.
  static QString of_now(const SessionSnapshot& snapshot, const Trial* trial, int to_come,
                        const QString& condition, double in_phase_s);
  /// The same beside the number of the trial that is under way or comes: "feeling 6.2 s", "next".
  static QString of_phase(const SessionSnapshot& snapshot, double in_phase_s);
  /// "4", "not explored as instructed"; `tells_right`: and whether it was right.
  static QString of_attempt(const AttemptSummary& attempt, bool tells_right);
  static State state_of(const AttemptSummary& attempt);
  static QString of_mode(SessionMode mode);
  /// What a button says that leads on after a failure.
  static QString of_way_on(AfterFailure way);
  /// "about 23 min, until 14:35"; without a time of day "about 23 min left"; unknown: "time left: –".
  static QString of_left(std::optional<double> left_s, const QString& until);
  /// "18:42", "1:02:05".
  static QString of_duration(double duration_s);
  /// "4", "3 1 2": answers as they were shown to the participant.
  static QString of_answers(const AttemptSummary& attempt);
};

}  // namespace asperity
