// Composes title, summary and validity of an attempt from its rows, in the words of the windows.

#include "app/gui/data/attempt_words.h"

#include "analysis/numbers/number_text.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/look/outcome_words.h"
#include "app/gui/look/words.h"
#include "results_schema/analysis_use.h"

namespace asperity {

QString AttemptWords::of_verdict(Verdict verdict) {
  switch (verdict) {
    case Verdict::set_aside:
      return tr("invalidated, repeated");
    case Verdict::flag:
      return tr("flagged");
    case Verdict::exclude:
      return tr("excluded");
    case Verdict::include:
      break;
  }
  return tr("included again");
}

QString AttemptWords::after_contact() { return tr("After contact, s"); }

QString AttemptWords::after_cue() { return tr("After cue, s"); }

void AttemptWords::explain_times(QAbstractItemModel& table, int contact_column, int cue_column) {
  table.setHeaderData(contact_column, Qt::Horizontal,
                      tr("Response time from the first contact with a surface in this attempt, in "
                         "seconds; it includes the whole exploration."),
                      Qt::ToolTipRole);
  table.setHeaderData(
      cue_column, Qt::Horizontal,
      tr("Response time from the cue, when the question was first asked, in seconds; it includes "
         "surfaces that were felt again before the response."),
      Qt::ToolTipRole);
}

QString AttemptWords::title(const AttemptDetail& detail) {
  return tr("Trial %1, attempt %2 · %3")
      .arg(detail.attempt.trial)
      .arg(detail.attempt.attempt)
      .arg(text(detail.session.participant));
}

QString AttemptWords::summary(const AttemptDetail& detail) {
  const AttemptRow& attempt = detail.attempt;
  const QString answers = OutcomeWords::of_responses(attempt.responses);
  const QString outcome = OutcomeWords::of(attempt.outcome);
  QStringList parts{tr("Session %1").arg(detail.session.session),
                    tr("%1 %2").arg(text(detail.protocol_name), text(detail.protocol_version)),
                    tr("block %1").arg(text(detail.planned.block)),
                    answers.isEmpty() ? outcome : tr("%1: %2").arg(outcome, answers)};
  const auto asked =
      std::find_if(attempt.responses.rbegin(), attempt.responses.rend(),
                   [](const ResponseRow& response) { return response.source != kNotAsked; });
  if (asked != attempt.responses.rend()) {
    parts << tr("answered %1 after the first contact").arg(of_seconds(asked->from_contact_s));
  }
  const double took_s = static_cast<double>(attempt.offset_ns - attempt.onset_ns) * 1e-9;
  parts << tr("took %1").arg(of_seconds(took_s)) << text_of_start(detail.session);
  return parts.join(" · ");
}

QString AttemptWords::standing(const AttemptDetail& detail) {
  const AttemptRow& attempt = detail.attempt;
  QStringList said{};
  if (!attempt.valid) {
    said << tr("Not counted: %1").arg(OutcomeWords::of_reason(attempt.invalid_reason));
  }
  if (detail.session.excluded) {
    said << tr("Excluded with its whole session: %1")
                .arg(OutcomeWords::of_reason(detail.session.excluded));
  } else if (attempt.excluded) {
    said << tr("Excluded: %1").arg(OutcomeWords::of_reason(attempt.excluded));
  }
  if (said.isEmpty()) {
    switch (use_in_analyses(detail.planned, attempt)) {
      case AnalysisUse::practice:
        said << (attempt.purpose == AttemptPurpose::refresher
                     ? tr("Practice repeated before the session was resumed: not included in "
                          "analyses")
                     : tr("Practice: not included in analyses"));
        break;
      case AnalysisUse::catch_trial:
        said << tr("Catch trial: not included in thresholds");
        break;
      case AnalysisUse::anchor:
        said << tr("Anchor: not included in analyses");
        break;
      case AnalysisUse::unanswered:
        said << tr("Not counted: no response");
        break;
      case AnalysisUse::invalid:
      case AnalysisUse::excluded:
        break;  // stated above, with the reason
      case AnalysisUse::counted:
        if (attempt.flagged) break;
        said << (detail.session.mode == SessionMode::pilot
                     ? tr("Counted in the analyses of pilot sessions")
                     : tr("Counted in the analyses"));
    }
  }
  if (attempt.flagged) {
    said << (said.isEmpty() ? tr("Counted but flagged: %1") : tr("flagged: %1"))
                .arg(OutcomeWords::of_reason(attempt.flag_reason));
  }
  return said.join(tr("; "));
}

State AttemptWords::state(const AttemptDetail& detail) {
  if (!detail.attempt.valid || detail.attempt.excluded) return State::stop;
  if (use_in_analyses(detail.planned, detail.attempt) != AnalysisUse::counted) {
    return State::unknown;
  }
  return detail.attempt.flagged ? State::look : State::fine;
}

QString AttemptWords::of_surface(const PresentationRow& surface) {
  QStringList names{};
  if (!surface.texture.empty()) names << text(surface.texture);
  if (!surface.model.empty()) names << text(surface.model);
  return tr("%1 · %2").arg(surface.position).arg(names.join(", "));
}

QString AttemptWords::of_seconds(const std::optional<double>& time_s) {
  return time_s ? tr("%1 s").arg(shown_number(*time_s, 'f', 2)) : QString("–");
}

}  // namespace asperity
