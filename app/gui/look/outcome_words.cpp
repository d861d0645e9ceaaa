#include "app/gui/look/outcome_words.h"

#include "app/gui/look/words.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"

namespace asperity {

QString OutcomeWords::of(AttemptOutcome outcome) {
  switch (outcome) {
    case AttemptOutcome::answered:
      return tr("answered");
    case AttemptOutcome::timed_out:
      return tr("no response in time");
    case AttemptOutcome::not_compliant:
      return tr("not explored as instructed");
    case AttemptOutcome::aborted:
      return tr("aborted");
    case AttemptOutcome::device_fault:
      return tr("fault");
    case AttemptOutcome::emergency_stop:
      return of_fault(Fault::emergency_stop);
    case AttemptOutcome::skipped:
      break;
  }
  return tr("skipped");
}

QString OutcomeWords::of_reason(const std::optional<StoredWords>& reason) {
  return reason ? words_of(phrase_of(*reason)) : QString("–");
}

QString OutcomeWords::of_fault(Fault fault) { return words_of(phrase_of(fault)); }

QString OutcomeWords::of_fault(const std::string& name) {
  const auto known = coded_phrases().find(name);
  return known == coded_phrases().end() ? text(name) : words_of(known->second);
}

QString OutcomeWords::of_event(const EventRow& event) { return words_of(phrase_of(event)); }

}  // namespace asperity
