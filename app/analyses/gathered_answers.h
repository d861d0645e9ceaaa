// The answers of a study that an analysis may count, sorted by protocol and by who gave them.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "results_schema/study.h"

namespace asperity {

/// Whose answers stand together in a table. They never mix.
enum class AnswerGroup {
  people,                ///< persons, in sessions that count (mode run)
  pilot,                 ///< persons, in pilot sessions
  virtual_participants,  ///< in whatever mode
};

/// "people", "pilot", "virtual".
const char* text_of(AnswerGroup group) noexcept;
/// Of the answers that a participant gives in a session.
AnswerGroup group_of(const ParticipantRow& participant, const SessionRow& session);

/// One surface that was felt before the answer.
struct FeltSurface {
  std::string item{};  ///< what it counts as in the answers
  std::string model{};
  std::string texture{};
  std::optional<double> matched_texture_force_N{};
  std::optional<double> achieved_texture_force_N{};
};

/// One valid, answered attempt at a trial of the main phase.
struct GatheredAnswer {
  std::string participant{};
  std::optional<std::string> sex{};
  std::string column{};                        ///< level of the factor `column`; empty without one
  std::vector<FeltSurface> surfaces{};         ///< by position
  std::vector<std::string> answers{};          ///< one for a choice; by position for an assignment
  std::vector<std::optional<bool>> correct{};  ///< of each answer
  std::vector<std::string> options{};          ///< that were open, as shown
};

/// What was left out, and what was kept although something was noticed.
struct AnswerCount {
  std::size_t participants = 0;
  std::size_t sessions = 0;
  std::size_t unfinished_sessions = 0;
  std::size_t guessing_sessions = 0;  ///< of virtual observers that are deaf or expect nothing
  std::size_t planned_trials = 0;     ///< of the main phase
  std::map<std::string, std::size_t> not_counted{};  ///< attempts of the main phase, by outcome
  std::size_t flagged = 0;                           ///< counted, but flagged
};

struct GatheredAnswers {
  std::string protocol{};
  std::string version{};
  std::string kind{};
  std::string design{};
  std::size_t sources = 0;  ///< different files that carry this name and version
  AnswerGroup group = AnswerGroup::people;
  AnswerCount count{};
  std::vector<GatheredAnswer> answers{};  ///< by participant and session
};

/// By protocol, version and group; empty groups are absent. With a `protocol` only those of that
/// name. When `stop` is requested, only the sessions that were read until then.
std::vector<GatheredAnswers> gather_answers(const Study& study,
                                            const std::optional<std::string>& protocol,
                                            const std::stop_token& stop);

/// The answer of somebody who will not choose, where the protocol allows it.
inline constexpr std::string_view kCannotTell = "cannot_tell";

/// The factor whose levels are the columns of the chapter's tables.
inline constexpr std::string_view kColumnFactor = "column";

}  // namespace asperity
