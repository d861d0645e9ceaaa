// Composes texts from a snapshot, a plan and attempts, with veiled names for a blind experimenter.

#include "app/gui/session/session_text.h"

#include <algorithm>
#include <set>

#include <QtCore/QStringList>

#include "app/gui/look/outcome_words.h"
#include "app/gui/look/words.h"
#include "app/gui/session/trial_under_way.h"
#include "protocols/file/protocol_reader.h"

namespace asperity {

NameVeil::NameVeil(const Protocol& protocol, const Plan& plan) {
  std::set<std::string> names{};
  const auto add = [&names](const std::string& name) {
    if (!name.empty()) names.insert(name);
  };
  for (const NamedFile& file : files_of(protocol)) add(file.path);
  for (const auto& [name, texture] : protocol.textures) add(name);
  for (const auto& [name, stimulus] : protocol.stimuli) add(name);
  for (const auto& [name, body] : protocol.bodies) add(name);
  for (const Trial& trial : plan.trials) {
    for (const PlannedPresentation& surface : trial.presentations) {
      add(surface.item);
      add(surface.stimulus.name);
      add(surface.stimulus.model);
      add(surface.stimulus.texture);
    }
  }
  QStringList patterns{};
  for (const std::string& name : names) {
    patterns += QRegularExpression::escape(QString::fromStdString(name));
  }
  // The longest first: a path goes as a whole, not but for the name in it.
  std::stable_sort(patterns.begin(), patterns.end(),
                   [](const QString& a, const QString& b) { return a.size() > b.size(); });
  if (patterns.isEmpty()) return;
  names_ = QRegularExpression(
      QString(R"((?<![\w])(?:%1)(?![\w]))").arg(patterns.join('|')),
      QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
  is_set_ = true;
}

QString NameVeil::veiled(const QString& text) const {
  if (!is_set_ || text.isEmpty()) return text;
  QString hidden = text;
  return hidden.replace(names_, "▒▒▒");
}

QString SessionText::of_now(const SessionSnapshot& snapshot, const Trial* trial, const int to_come,
                            const QString& condition, double in_phase_s) {
  if (snapshot.purpose == AttemptPurpose::refresher && is_in_trial(snapshot)) {
    SessionSnapshot of_trial = snapshot;
    of_trial.purpose = AttemptPurpose::trial;
    return tr("Repeated practice: %1").arg(of_now(of_trial, trial, to_come, condition, in_phase_s));
  }
  const QString seconds = shown_number(std::max(0.0, in_phase_s), 'f', 1);
  switch (snapshot.phase) {
    case SessionPhase::idle:
      return tr("The session has not begun");
    case SessionPhase::ready:
      return snapshot.trials > 0 && snapshot.trials_done >= snapshot.trials
                 ? tr("After the last trial: the participant is reading")
                 : tr("Preparation: the participant is reading, or the device is being checked");
    case SessionPhase::iti:
      return to_come > 0 ? tr("Between trials; next: trial %1").arg(to_come) : tr("Between trials");
    case SessionPhase::fore:
      return tr("Trial %1: waiting for the first touch, %2 s").arg(snapshot.trial).arg(seconds);
    case SessionPhase::contact: {
      const QString contact = shown_number(snapshot.contact_s, 'f', 1);
      const std::size_t surfaces = trial == nullptr ? 0 : trial->presentations.size();
      if (trial != nullptr && trial->arrangement.surfaces == Arrangement::Surfaces::side_by_side) {
        return tr("Trial %1: feeling %2 surfaces side by side, %3 s")
            .arg(snapshot.trial)
            .arg(surfaces)
            .arg(contact);
      }
      if (snapshot.surface > 0 && surfaces > 1) {
        return tr("Trial %1: feeling surface %2 of %3 (%4), %5 s")
            .arg(snapshot.trial)
            .arg(snapshot.surface)
            .arg(surfaces)
            .arg(condition, contact);
      }
      return tr("Trial %1: feeling %2, %3 s").arg(snapshot.trial).arg(condition, contact);
    }
    case SessionPhase::response:
      return tr("Trial %1: answering, %2 s").arg(snapshot.trial).arg(seconds);
    case SessionPhase::feedback:
      return snapshot.purpose == AttemptPurpose::refresher
                 ? tr("Repeated practice: feedback")
                 : tr("Trial %1: feedback").arg(snapshot.last_done);
    case SessionPhase::rest:
      return tr("Break, %1").arg(of_duration(in_phase_s));
    case SessionPhase::questions:
      return tr("The participant is answering questions");
    case SessionPhase::paused:
      return to_come > 0 ? tr("Paused before trial %1").arg(to_come) : tr("Paused");
    case SessionPhase::fault:
      return tr("Stopped: the force is held at zero");
    case SessionPhase::ended:
      return tr("The session has ended");
  }
  return {};
}

QString SessionText::of_phase(const SessionSnapshot& snapshot, double in_phase_s) {
  const QString seconds = shown_number(std::max(0.0, in_phase_s), 'f', 1);
  switch (snapshot.phase) {
    case SessionPhase::fore:
      return tr("waiting for touch %1 s").arg(seconds);
    case SessionPhase::contact:
      return tr("feeling %1 s").arg(shown_number(snapshot.contact_s, 'f', 1));
    case SessionPhase::response:
      return tr("answering %1 s").arg(seconds);
    case SessionPhase::fault:
      return tr("stopped");
    case SessionPhase::paused:
      return tr("paused before this trial");
    case SessionPhase::rest:
      return tr("after the break");
    case SessionPhase::idle:
    case SessionPhase::ready:
    case SessionPhase::iti:
    case SessionPhase::feedback:
    case SessionPhase::questions:
      return tr("next");
    case SessionPhase::ended:
      break;
  }
  return {};
}

QString SessionText::of_answers(const AttemptSummary& attempt) {
  QStringList answers{};
  for (const std::string& answer : attempt.answers) answers += OutcomeWords::of_response(answer);
  return answers.join(' ');
}

QString SessionText::of_attempt(const AttemptSummary& attempt, bool tells_right) {
  if (attempt.purpose == AttemptPurpose::refresher) {
    AttemptSummary practised = attempt;
    practised.purpose = AttemptPurpose::trial;
    return tr("%1, practised again").arg(of_attempt(practised, tells_right));
  }
  const QString outcome = OutcomeWords::of(attempt.outcome);
  if (attempt.outcome != AttemptOutcome::answered) return outcome;
  const QString answers = of_answers(attempt);
  QString text = answers.isEmpty() ? outcome : answers;
  if (tells_right && attempt.correct) {
    text = *attempt.correct ? tr("%1, correct").arg(text) : tr("%1, incorrect").arg(text);
  }
  if (!attempt.valid) return tr("%1, not counted").arg(text);
  return attempt.flagged ? tr("%1, flagged").arg(text) : text;
}

State SessionText::state_of(const AttemptSummary& attempt) {
  return attempt.outcome == AttemptOutcome::answered && attempt.valid && !attempt.flagged
             ? State::fine
             : State::look;
}

QString SessionText::of_mode(SessionMode mode) {
  switch (mode) {
    case SessionMode::run:
      return tr("RUN");
    case SessionMode::pilot:
      return tr("PILOT");
    case SessionMode::simulate:
      return tr("SIMULATE");
  }
  return {};
}

QString SessionText::of_way_on(AfterFailure way) {
  switch (way) {
    case AfterFailure::start_again:
      return tr("Try again");
    case AfterFailure::check_again:
      return tr("Check again");
    case AfterFailure::go_on:
      break;
  }
  return tr("Resume this session…");
}

QString SessionText::of_left(std::optional<double> left_s, const QString& until) {
  if (!left_s) return tr("time left: –");
  if (*left_s < 60.0) {
    return until.isEmpty() ? tr("less than a minute left")
                           : tr("less than a minute, until %1").arg(until);
  }
  const int minutes = static_cast<int>(*left_s / 60.0 + 0.5);
  return until.isEmpty() ? tr("about %1 min left").arg(minutes)
                         : tr("about %1 min, until %2").arg(minutes).arg(until);
}

QString SessionText::of_duration(double duration_s) {
  const int seconds = static_cast<int>(std::max(0.0, duration_s));
  const QString tail = QString("%1:%2")
                           .arg(seconds / 60 % 60, 2, 10, QChar('0'))
                           .arg(seconds % 60, 2, 10, QChar('0'));
  return seconds < 3600 ? tail : QString("%1:%2").arg(seconds / 3600).arg(tail);
}

}  // namespace asperity
