// Checks a participant's label, and the data that a study already has under it, before a session begins.

#pragma once

#include <optional>
#include <string>

#include "analysis/words/phrase.h"
#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// The problem of a label that is to become part of file names; nothing when it is acceptable.
/// Labels that begin with "virtual" are reserved for virtual participants.
std::optional<Phrase> complaint_about_label(const std::string& label, bool is_virtual);

/// The sessions of one mode that a participant has with exactly the text of a protocol.
struct ParticipantSessions {
  int ended = 0;                           ///< completed, or ended by a rule of the protocol
  std::optional<SessionRow> unfinished{};  ///< the latest of the others
};
/// Errors: ResultsError.
ParticipantSessions sessions_of_participant(const Study& study, const Protocol& protocol,
                                            const std::string& participant, SessionMode mode);

/// A fact about the label of a new session that may show that another label, or no new session, was intended.
struct LabelNotice {
  Phrase text{};                 ///< a sentence without its full stop
  Phrase remedy{};               ///< for windows; empty where this is expected
  std::string command_remedy{};  ///< for the command line
  bool is_planned = false;       ///< the protocol plans a further session
  std::string similar_label{};  ///< of another participant; empty: the label itself is in the study
};
/// For a session that begins; not for one that is resumed. Nothing where the label is new and
/// unlike all others, or has no session of a protocol of this name, in any version and mode,
/// because a participant who knows the task from a pilot session is not naive. Labels that differ
/// only in letter case or in leading zeros are alike.
///
/// Errors: ResultsError.
std::optional<LabelNotice> label_notice(const Study& study, const Protocol& protocol,
                                        const std::string& participant, SessionMode mode);

}  // namespace asperity
