// How an attempt came out and what stopped it, in words: the same in a session and afterwards.

#pragma once

#include <optional>
#include <string>

#include <QtCore/QCoreApplication>
#include <QtCore/QString>

#include "renderers/servo/servo_loop.h"
#include "results_schema/rows.h"

namespace asperity {

class OutcomeWords final {
  Q_DECLARE_TR_FUNCTIONS(OutcomeWords)
 public:
  /// "no response in time".
  static QString of(AttemptOutcome outcome);
  /// Why something does not count, is flagged or was decided: the program's own reasons in the language of
  /// the windows, what somebody typed as it is. "–" where nothing is stored.
  static QString of_reason(const std::optional<StoredWords>& reason);
  static QString of_fault(Fault fault);
  /// As a row stores it: by its name.
  static QString of_fault(const std::string& name);
  /// The text of an event.
  static QString of_event(const EventRow& event);
};

}  // namespace asperity
