// The answers of a study that an analysis may count, sorted by protocol and by who gave them.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "protocols/design/analysis_declaration.h"
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

/// Words, each told by its place: there are few words and a million answers.
class Words final {
 public:
  std::uint32_t place(const std::string& word);
  const std::string& at(std::uint32_t place) const { return words_.at(place); }
  std::size_t size() const noexcept { return words_.size(); }
  /// Nothing where nobody has used it.
  std::optional<std::uint32_t> find(const std::string& word) const;

 private:
  std::vector<std::string> words_{};
  std::unordered_map<std::string, std::uint32_t> places_{};
};

/// One surface that was felt before the answer, as places of words.
struct FeltSurface {
  std::uint32_t item = 0;  ///< what it counts as in the answers
  std::uint32_t texture = 0;
};

/// What was answered: to a choice once, in an assignment for each surface.
struct GatheredReply {
  std::uint32_t answer = 0;  ///< a place of a word
  std::optional<bool> correct{};
};

/// One valid, answered attempt at a trial of the main phase.
struct GatheredAnswer {
  std::uint32_t person = 0;  ///< which of the people
  /// Word of the level of the factor `column`, or of the condition of a magnitude; the empty one
  /// without.
  std::uint32_t column = 0;
  std::uint32_t spacing = 0;  ///< of a magnitude: word of the level of its spacings
  std::uint32_t options = 0;  ///< which of the option lists
  int repetition = 1;         ///< of the block, as planned
  /// From the cue, when the question was put first, to the response; an assignment has one. Nothing where none is
  /// stored, or of no length.
  std::optional<double> response_time_s{};
  std::uint16_t surface_count = 0;
  std::uint16_t reply_count = 0;
  std::size_t first_surface = 0;
  std::size_t first_reply = 0;
};

struct AnsweringPerson {
  std::string label{};
  std::optional<std::string> sex{};
};

/// Texture force of the surfaces that one force model rendered.
struct TextureForces {
  std::size_t surfaces = 0;
  std::vector<double> matched_N{};   ///< aimed at, where it was
  std::vector<double> achieved_N{};  ///< where the surface was felt for long enough
};

/// How attempts at analysed trials that do not count are named in counts: "excluded", "answered but invalid", or else
/// their outcome.
std::string fate_of(AnalysisUse use, AttemptOutcome outcome);

/// What was left out, and what was kept although something was noticed.
struct AnswerCount {
  std::size_t participants = 0;
  std::size_t sessions = 0;
  std::size_t unfinished_sessions = 0;
  std::size_t guessing_sessions = 0;  ///< of virtual observers that are deaf or expect nothing
  /// Of human participants, begun on a device without motors or on one that the program moved.
  std::size_t unfelt_sessions = 0;
  std::size_t planned_trials = 0;                    ///< of the main phase
  std::map<std::string, std::size_t> not_counted{};  ///< attempts of the main phase, by outcome
  std::size_t flagged = 0;                           ///< counted, but flagged
  std::size_t anchors = 0;  ///< numbers of a magnitude that are not analysed
};

struct GatheredAnswers {
  std::string protocol{};
  std::string version{};
  std::string kind{};
  std::string design{};
  std::size_t sources =
      0;  ///< files that carry this name and version and differ in more than texts
  AnalysisDeclaration declared{};
  EstimationDeclaration estimation{};  ///< of a magnitude
  std::vector<std::string> pictures{};  ///< of matching and recognition, in the protocol's order
  /// Of a selection: what alone its alternatives differ in, by all of those files.
  std::optional<std::string> compared_parameter{};
  bool declared_alike = true;  ///< by all of those files; otherwise nothing counts as declared
  AnswerGroup group = AnswerGroup::people;
  AnswerCount count{};
  Words words{};
  std::vector<AnsweringPerson> people{};                 ///< with an answer, by label
  std::vector<std::vector<std::string>> option_lists{};  ///< as shown, each order once
  std::vector<GatheredAnswer> answers{};                 ///< by participant and session
  std::vector<FeltSurface> surfaces{};
  std::vector<GatheredReply> replies{};
  std::map<std::string, TextureForces> forces{};  ///< by model

  /// Whether responses are numbers that are analysed by the protocol's key `estimation`.
  bool has_estimates() const noexcept { return !estimation.spacing.empty(); }
  /// By position.
  std::span<const FeltSurface> surfaces_of(const GatheredAnswer& answer) const {
    return std::span(surfaces).subspan(answer.first_surface, answer.surface_count);
  }
  std::span<const GatheredReply> replies_of(const GatheredAnswer& answer) const {
    return std::span(replies).subspan(answer.first_reply, answer.reply_count);
  }
  const GatheredReply& reply_of(const GatheredAnswer& answer) const {
    return replies[answer.first_reply];
  }
  const std::string& word(std::uint32_t place) const { return words.at(place); }
  /// The spacing of a magnitude in metres; nothing where its level is no length and the protocol declares none.
  std::optional<double> spacing_m(const GatheredAnswer& answer) const;
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
