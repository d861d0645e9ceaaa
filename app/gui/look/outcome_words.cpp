#include "app/gui/look/outcome_words.h"

#include <array>

namespace asperity {

namespace {

constexpr std::array kFaults{Fault::none,       Fault::emergency_stop, Fault::device_lost,
                             Fault::not_finite, Fault::workspace_left, Fault::repeated_misses};

}  // namespace

QString OutcomeWords::of(AttemptOutcome outcome, const std::string& reason) {
  switch (outcome) {
    case AttemptOutcome::answered:
      return tr("answered");
    case AttemptOutcome::timed_out:
      return tr("no answer in time");
    case AttemptOutcome::not_compliant:
      return tr("not explored as asked");
    case AttemptOutcome::aborted:
      return tr("aborted");
    case AttemptOutcome::device_fault:
      return reason == name_of(Fault::emergency_stop) ? of_fault(Fault::emergency_stop)
                                                      : tr("device fault");
    case AttemptOutcome::skipped:
      break;
  }
  return tr("skipped");
}

QString OutcomeWords::of_reason(const std::string& reason) {
  for (const Fault fault : kFaults) {
    if (reason == name_of(fault)) return of_fault(fault);
  }
  return QString::fromStdString(reason);
}

QString OutcomeWords::of_fault(Fault fault) {
  switch (fault) {
    case Fault::emergency_stop:
      return tr("emergency stop");
    case Fault::device_lost:
      return tr("the device does not answer");
    case Fault::not_finite:
      return tr("a force or position that is not a finite number");
    case Fault::workspace_left:
      return tr("the probe left the workspace");
    case Fault::repeated_misses:
      return tr("too many missed deadlines");
    case Fault::none:
      break;
  }
  return tr("none");
}

}  // namespace asperity
