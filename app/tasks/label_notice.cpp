// Composes a notice from the newest session under the label, its origin and the kind of its data.

#include "app/tasks/label_notice.h"

#include <algorithm>

#include "app/session/rig/clock.h"
#include "app/session/session_setup.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/unfinished_session.h"
#include "app/words/time_ago.h"
#include "app/words/utc_time.h"
#include "results_schema/tables/name_forms.h"

namespace asperity {

namespace {

Phrase time_of(const Study& study, const SessionRow& row) {
  if (has_made_up_dates(row)) return phrase("LabelNotice", "on a simulated clock");
  return time_ago(hours_since_it_ran(study, row));
}

Phrase origin_of(const ParticipantRow& person) {
  if (person.is_virtual) return phrase("LabelNotice", "virtual participant");
  const double days = days_since_1970(SystemClock(0).utc()) - days_since_1970(person.created_utc);
  return phrase("LabelNotice", "added %1").with(time_ago(kHoursADay * days));
}

Phrase data_of(SessionMode mode) {
  switch (mode) {
    case SessionMode::run:
      return phrase("LabelNotice", "study data");
    case SessionMode::pilot:
      return phrase("LabelNotice", "pilot data");
    case SessionMode::simulate:
      break;
  }
  return phrase("LabelNotice", "simulated data");
}

/// The notice for a label that is not in the study.
std::optional<LabelNotice> notice_of_new_label(const Study& study, const std::string& label) {
  const std::string form = label_form(label);
  for (const ParticipantRow& person : study.participants()) {
    if (label_form(person.label) != form) continue;
    return LabelNotice{
        .text = phrase("LabelNotice",
                       "%1 is a new participant; %2, whose label differs only in letter case or "
                       "leading zeros, is in the study already (%3)")
                    .with(label, person.label, origin_of(person)),
        .remedy = phrase("LabelNotice", "If %1 is meant, use that label.").with(person.label),
        .command_remedy = "for " + person.label + ", use --participant " + person.label,
        .similar_label = person.label};
  }
  return {};
}

/// The notice that the participant, or the session, may be a mistake.
LabelNotice notice_of(const Study& study, const Protocol& protocol, const SessionRow& latest) {
  const ProtocolRow row = study.protocol(latest.protocol_id);
  const Phrase circumstances = phrase("LabelNotice", "%1, version %2, %3")
                                   .with(data_of(latest.mode), row.version, time_of(study, latest));
  const std::string session = std::to_string(latest.session);
  if (has_ended(study, protocol, latest)) {
    return {
        .text =
            phrase("LabelNotice",
                   "%1 has completed session %2 of this protocol (%3); a further session begins")
                .with(latest.participant, session, circumstances),
        .remedy = phrase("LabelNotice", "For another participant, use another label."),
        .command_remedy = "for another participant, use another --participant"};
  }
  const Phrase text =
      phrase("LabelNotice",
             "session %2 of %1 with this protocol is unfinished (%3); a further session begins")
          .with(latest.participant, session, circumstances);
  if (row.source == protocol.source) {
    return {.text = text,
            .remedy = phrase("LabelNotice", "Resume it, or use another label."),
            .command_remedy = "to resume it, use --resume"};
  }
  return {.text = text,
          .remedy = phrase("LabelNotice",
                           "To resume it, choose the protocol file with which the session began."),
          .command_remedy =
              "to resume it, use --resume and the protocol file with which the session began"};
}

}  // namespace

ParticipantSessions sessions_of_participant(const Study& study, const Protocol& protocol,
                                            const std::string& participant, SessionMode mode) {
  ParticipantSessions sessions{};
  for (const SessionRow& row : study.sessions()) {
    if (row.participant != participant || row.mode != mode ||
        study.protocol(row.protocol_id).source != protocol.source) {
      continue;
    }
    if (has_ended(study, protocol, row)) {
      ++sessions.ended;
    } else {
      sessions.unfinished = row;
    }
  }
  return sessions;
}

std::optional<LabelNotice> label_notice(const Study& study, const Protocol& protocol,
                                        const std::string& participant, SessionMode mode) {
  if (!study.participant(participant)) return notice_of_new_label(study, participant);
  std::optional<SessionRow> latest{};
  for (const SessionRow& row : study.sessions()) {
    if (row.participant == participant && study.protocol(row.protocol_id).name == protocol.name) {
      latest = row;
    }
  }
  if (!latest) return {};
  const int ended = sessions_of_participant(study, protocol, participant, mode).ended;
  const bool is_next = mode == SessionMode::run && latest->mode == mode && ended > 0 &&
                       ended < protocol.sessions &&
                       study.protocol(latest->protocol_id).source == protocol.source;
  if (!is_next) return notice_of(study, protocol, *latest);
  return LabelNotice{
      .text = phrase("LabelNotice",
                     "%1 has completed %2 of %3 planned sessions of this protocol, the latest %4")
                  .with(participant, std::to_string(ended), std::to_string(protocol.sessions),
                        time_of(study, *latest)),
      .is_planned = true};
}

std::optional<Phrase> complaint_about_label(const std::string& label, bool is_virtual) {
  const bool characters = std::all_of(label.begin(), label.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  if (characters && !label.empty() && label.size() <= 32) {
    if (is_virtual || !label.starts_with("virtual")) return {};
    return phrase("ProtocolFiles",
                  "the participant label \"%1\" is not acceptable for a human participant: labels "
                  "that begin with \"virtual\" are reserved for virtual participants; use another "
                  "label")
        .with(label);
  }
  return phrase("ProtocolFiles",
                "the participant label \"%1\" is not acceptable: it must consist of 1 to 32 "
                "letters and digits (0-9, A-Z, a-z)")
      .with(label);
}

}  // namespace asperity
