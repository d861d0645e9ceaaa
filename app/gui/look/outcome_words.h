// How an attempt came out and what stopped it, in words: the same in a session and afterwards.

#pragma once

#include <string>

#include <QtCore/QCoreApplication>
#include <QtCore/QString>

#include "renderers/servo_loop.h"
#include "results_schema/rows.h"

namespace asperity {

class OutcomeWords final {
  Q_DECLARE_TR_FUNCTIONS(OutcomeWords)
 public:
  /// "no answer in time".
  static QString of(AttemptOutcome outcome);
  /// Why something does not count, is flagged or ended, as stored: the program's own reasons in the
  /// language of the windows, what somebody typed as it is.
  static QString of_reason(const std::string& reason);
  static QString of_fault(Fault fault);
};

}  // namespace asperity
