// Translates outcomes, reasons, faults and events by their phrases, and shortens long responses.

#include "app/gui/look/outcome_words.h"

#include <algorithm>
#include <cstddef>

#include <QtCore/QLocale>
#include <QtCore/QStringList>

#include "analysis/numbers/rounded_text.h"
#include "app/gui/look/words.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"

namespace asperity {

namespace {

constexpr int kMostCharacters = 12;  // of a number that someone entered

}  // namespace

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

QString OutcomeWords::of_response(const std::string& label) {
  const std::size_t end = std::min(label.find(' '), label.size());
  const std::string first = label.substr(0, end);
  bool is_number = false;
  const double value = QString::fromStdString(first).toDouble(&is_number);
  // "007" and "1e5" are names.
  if (!is_number || number_text(value) != first) return text(label);
  const std::string rounded = rounded_text(value);
  const auto length = static_cast<qsizetype>(rounded.size());
  QString shown = length > kMostCharacters
                      ? shown_number(value, 'g', 6)
                      : QString::fromStdString(rounded).replace('.', QLocale().decimalPoint());
  if (shown.startsWith('-')) shown.replace(0, 1, "−");
  return shown + text(label.substr(end));
}

QString OutcomeWords::of_responses(const std::vector<ResponseRow>& responses) {
  QStringList shown{};
  for (const ResponseRow& response : responses) {
    if (response.source == kNotAsked) continue;
    const QString answer = of_response(response.answer);
    shown << (responses.size() > 1 ? QString("%1 %2").arg(response.item).arg(answer) : answer);
  }
  return shown.join(", ");
}

QString OutcomeWords::of_event(const EventRow& event) { return words_of(phrase_of(event)); }

}  // namespace asperity
