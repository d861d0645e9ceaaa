// Checks label, lock, kind, withdrawal and earlier sessions, in this order.

#include "app/tasks/checks/participant_check.h"

#include <optional>
#include <string>

#include "app/session/session_setup.h"
#include "app/tasks/label_notice.h"
#include "app/tasks/unfinished_session.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

Phrase holder_text(const LockHolder& holder) {
  if (holder.process.empty()) return holder.description;
  return phrase("SessionChecks", "process %1 on host %2, started %3")
      .with(holder.process, holder.host, holder.started_utc);
}

}  // namespace

SessionCheck participant_check(const CheckInputs& inputs, const Protocol& protocol) {
  SessionCheck check{.state = State::stop};
  const bool is_virtual = inputs.mode == SessionMode::simulate;
  if (inputs.participant.empty()) {
    check.text = phrase("SessionChecks", "No participant has been chosen yet.");
    check.remedy = phrase("SessionChecks", "Choose a participant, or enter a new label.");
    return check;
  }
  if (const auto complaint = complaint_about_label(inputs.participant, is_virtual)) {
    check.text = complaint->as_sentence();
    check.remedy = phrase("SessionChecks", "Enter another label.");
    return check;
  }
  if (const auto holder =
          StudyLock::holder(inputs.study, Study::session_lock_name(inputs.participant))) {
    check.text = phrase("SessionChecks", "A session of %1 is running in %2.")
                     .with(inputs.participant, holder_text(*holder));
    check.remedy = phrase("SessionChecks", "Wait until it has ended, or stop it there.");
    return check;
  }
  const Study study = Study::open(inputs.study, Access::read_only);
  const std::optional<ParticipantRow> known = study.participant(inputs.participant);
  if (known && known->is_virtual != is_virtual) {
    check.text = (known->is_virtual ? phrase("SessionChecks", "%1 is a virtual participant.")
                                    : phrase("SessionChecks", "%1 is a human participant."))
                     .with(inputs.participant);
    check.remedy =
        known->is_virtual
            ? phrase("SessionChecks", "Choose a human participant, or switch to Simulate.")
            : phrase("SessionChecks",
                     "Use the label that the program assigns, or switch to Run or Pilot.");
    return check;
  }
  if (known && known->withdrawn) {
    check.text = phrase("SessionChecks", "%1 has withdrawn.").with(inputs.participant);
    check.remedy = phrase("SessionChecks", "Enter another label.");
    return check;
  }
  if (inputs.resume) {
    const std::optional<SessionRow> resumed =
        unfinished_row(study, protocol, inputs.participant, inputs.resumed_session);
    if (!resumed) {
      check.text = phrase("SessionChecks",
                          "%1 has no unfinished session of this protocol in its present form.")
                       .with(inputs.participant);
      check.remedy = phrase("SessionChecks", "Start a new session instead.");
      return check;
    }
    if (const auto late = late_resume(study, protocol, *resumed)) {
      check.text = complaint_about(*late).as_sentence();
      if (inputs.late_reason.empty()) {
        check.remedy = phrase("SessionChecks", "Enter the reason for resuming it.");
        return check;
      }
      check.state = State::look;
      check.remedy = phrase("SessionChecks", "The reason is stored and stated in the report.");
      return check;
    }
    check.state = State::fine;
    check.text = phrase("SessionChecks", "Session %1 can be resumed.")
                     .with(std::to_string(resumed->session));
    return check;
  }
  const auto [completed, unfinished] =
      sessions_of_participant(study, protocol, inputs.participant, inputs.mode);
  if (!is_virtual && unfinished) {
    check.text = phrase("SessionChecks", "Session %1 of this protocol is unfinished.")
                     .with(std::to_string(unfinished->session));
    check.remedy = phrase("SessionChecks", "Resume it; a new one can start when it is complete.");
    return check;
  }
  if (inputs.mode == SessionMode::run && completed >= protocol.sessions) {
    check.text =
        phrase("SessionChecks", "%1 has completed all planned sessions (%2 of %3).")
            .with(inputs.participant, std::to_string(completed), std::to_string(protocol.sessions));
    check.remedy = phrase("SessionChecks", "Choose another participant.");
    return check;
  }
  if (const auto notice = label_notice(study, protocol, inputs.participant, inputs.mode)) {
    check.state = notice->is_planned ? State::fine : State::look;
    check.text = notice->text.as_sentence();
    check.remedy = notice->remedy;
    return check;
  }
  check.state = State::fine;
  check.text =
      (known ? phrase("SessionChecks",
                      "%1 is a participant of the study and has no session running elsewhere.")
             : phrase("SessionChecks", "%1 is new and has no session running elsewhere."))
          .with(inputs.participant);
  return check;
}

}  // namespace asperity
