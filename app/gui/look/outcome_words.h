// How an attempt came out and what stopped it, in words: the same in a session and afterwards.

#pragma once

#include <optional>
#include <string>
#include <vector>

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
  /// A response as its question labels it, "4", "B", "3 (rough)": a number without rounding errors, with six significant
  /// digits where a participant would not enter it in full, and the user's decimal point.
  static QString of_response(const std::string& label);
  /// All responses of an attempt: "4", or "1 4, 2 6" by item.
  static QString of_responses(const std::vector<ResponseRow>& responses);
  /// The text of an event.
  static QString of_event(const EventRow& event);
};

}  // namespace asperity
