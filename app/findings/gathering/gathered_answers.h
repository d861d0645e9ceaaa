// Stores the responses of a study that an analysis may count, by protocol, group and kind of experiment.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "app/findings/gathering/gathered_exploration.h"
#include "app/records/felt_octaves.h"
#include "app/records/presented_matches.h"
#include "protocols/answers/question.h"
#include "protocols/design/analysis_declaration.h"
#include "protocols/design/protocol.h"
#include "protocols/file/stored_protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// Groups whose responses are tabulated separately. They are never combined.
enum class AnswerGroup {
  people,                ///< persons, in sessions that count (mode run)
  pilot,                 ///< persons, in pilot sessions
  virtual_participants,  ///< in any mode
};

/// "people", "pilot", "virtual".
const char* text_of(AnswerGroup group) noexcept;
/// The group of the responses of a participant in a session.
AnswerGroup group_of(const ParticipantRow& participant, const SessionRow& session);

/// Stores words once and refers to them by index: there are few words and up to a million
/// responses.
class Words final {
 public:
  std::uint32_t place(const std::string& word);
  const std::string& at(std::uint32_t place) const { return words_.at(place); }
  std::size_t size() const noexcept { return words_.size(); }
  /// Nothing where the word is not stored.
  std::optional<std::uint32_t> find(const std::string& word) const;

 private:
  std::vector<std::string> words_{};
  std::unordered_map<std::string, std::uint32_t> places_{};
};

/// The empty word, which every group has.
inline constexpr std::uint32_t kNoWord = 0;

/// The factor whose levels are the columns of the chapter's tables.
inline constexpr std::string_view kColumnFactor = "column";

/// One surface that was felt before the response, as indices of words.
struct FeltSurface {
  std::uint32_t item = 0;  ///< the item that it counts as in the responses
  std::uint32_t texture = 0;
};

/// A response: one to a choice, one per surface in an assignment.
struct GatheredReply {
  std::uint32_t answer = 0;  ///< index of a word
  std::optional<bool> correct{};
  std::optional<double> number{};  ///< where the response is one
};

/// The response to the question that a scale accompanies, in the same attempt.
struct AccompaniedResponse {
  std::uint32_t question = kNoWord;  ///< word of its name
  std::uint32_t answer = kNoWord;    ///< of a choice; `kNoWord` of an assignment and of a number
  /// Of an assignment: whether all items are correct. Nothing where no response is correct or incorrect.
  std::optional<bool> correct{};
};

/// The answer to one question in a valid attempt at a trial of the main phase.
struct GatheredAnswer {
  std::uint32_t person = 0;    ///< index in `people`
  std::uint32_t block = 0;     ///< word of its name
  std::uint32_t question = 0;  ///< word of its name
  std::uint32_t factors = 0;   ///< index in `factor_levels`
  std::uint32_t options = 0;   ///< index in `option_lists`
  int repetition = 1;          ///< of the block, as planned
  int session = 1;             ///< ordinal within the participant
  int block_ordinal = 1;       ///< of the run of the block within the session
  int trial_of_block = 1;      ///< place in the run of the block, as planned
  /// Where a procedure chose the level: the track within the run of the block, and the place in it, from 1; otherwise 0.
  int track = 0;
  int step = 0;
  /// Not the first answer of its trial: the trial asks several questions.
  bool continues_trial = false;
  /// The session was interrupted and not resumed, or is not over.
  bool session_is_unfinished = false;
  /// From the cue, when the question was asked first, to the response; an assignment has one
  /// response time. Nothing where none is stored, or where it is not above 0.
  std::optional<double> response_time_s{};
  /// Where the question accompanies one of another kind in its block.
  std::optional<AccompaniedResponse> accompanied{};
  /// The rating of the confidence of this response, in the same attempt.
  std::optional<double> confidence{};
  std::uint16_t surface_count = 0;
  std::uint16_t reply_count = 0;
  std::size_t first_surface = 0;
  std::size_t first_reply = 0;
};

struct AnsweringPerson {
  std::string label{};
  std::optional<std::string> sex{};
  std::optional<std::string> group{};  ///< to which the protocol assigns the participant
  /// In which it did (GroupBlocks); nothing where it does not assign in permuted blocks, or the block is unknown.
  std::optional<std::string> block{};
};

/// Texture force of the surfaces that one force model rendered.
struct TextureForces {
  std::size_t surfaces = 0;
  std::vector<double> matched_N{};   ///< the target, where there was one
  std::vector<double> achieved_N{};  ///< where the surface was felt for long enough
};

/// Of the surfaces that count as one item, as far as they were felt for long enough.
struct ItemTextureForce {
  std::size_t surfaces = 0;
  double sum_N = 0.0;  ///< of the RMS texture forces along the participants' paths

  double mean_N() const { return sum_N / static_cast<double>(surfaces); }
};

/// The name under which attempts at analysed trials that do not count are counted: "excluded",
/// "answered but invalid", or otherwise their outcome.
std::string fate_of(AnalysisUse use, AttemptOutcome outcome);

/// The valid attempts of a participant at the catch trials of a block. A missed deadline is not correct.
struct CatchResponses {
  std::string participant{};
  std::string block{};
  /// By the surfaces that were felt and the judgement of the block.
  CatchType type = CatchType::easy;
  std::size_t trials = 0;
  std::size_t correct = 0;
};

/// The response to one question in a valid attempt at an anchor.
struct AnchorResponse {
  std::string participant{};
  int session = 1;        ///< ordinal within the participant
  int block_ordinal = 1;  ///< of the run of the block within the session
  std::string block{};
  AnchorPlace place = AnchorPlace::start;
  std::string question{};
  std::string answer{};             ///< of an assignment, its items by position: "metal, wood"
  std::optional<double> number{};   ///< where the response is one
  std::optional<double> correct{};  ///< the proportion of its items; nothing where none can be
};

/// Counts what was omitted, and what was kept with a warning.
struct AnswerCount {
  std::size_t participants = 0;
  std::size_t sessions = 0;
  std::size_t unfinished_sessions = 0;
  std::size_t guessing_sessions = 0;  ///< of virtual observers that are deaf or have no expectation
  /// Of human participants, begun on a device without motors or on one that the program moved.
  std::size_t unfelt_sessions = 0;
  std::size_t planned_trials = 0;                    ///< of the main phase
  std::map<std::string, std::size_t> not_counted{};  ///< attempts of the main phase, by outcome
  std::size_t flagged = 0;                           ///< counted, but flagged
  std::size_t anchors = 0;  ///< numbers of a magnitude that are not analysed
};

/// The match of a stimulus in a session, by the amplitude at which the session presented it.
struct ParticipantMatch {
  std::string participant{};
  int session = 1;
  PresentedMatch match{};
};

struct GatheredAnswers {
  std::string protocol{};
  std::string version{};
  std::string title{};
  std::string kind{};  ///< of the questions that are answered
  std::string design{};
  /// The questions of this kind in main blocks, each name once, in the order of the protocol.
  std::vector<Protocol::TrialQuestionTemplate> questions{};
  /// The main blocks with such a question, by name; of several files, as the first one states them.
  std::map<std::string, Protocol::Block, std::less<>> blocks{};
  /// By the same: the factors whose levels determine its surfaces, each once.
  std::map<std::string, std::vector<std::string>, std::less<>> surface_factors{};
  std::size_t sources = 0;  ///< files of this name and version that differ in more than texts
  AnalysisDeclaration declared{};
  EstimationDeclaration estimation{};  ///< of a magnitude
  /// To which the protocol assigns participants, in its order, as far as they have responses.
  std::vector<std::string> groups{};
  std::string group_factor{};           ///< whose levels the groups are; empty: none
  std::vector<std::string> pictures{};  ///< of matching and recognition, in the protocol's order
  /// Of a selection: the only parameter in which its alternatives differ, in all of those files.
  std::optional<std::string> compared_parameter{};
  /// All questions of this kind in main blocks accompany questions of other kinds.
  bool only_accompanies = false;
  bool declared_alike = true;  ///< in all of those files; otherwise nothing counts as declared
  AnswerGroup group = AnswerGroup::people;
  AnswerCount count{};
  Words words{};
  std::vector<AnsweringPerson> people{};                 ///< with a response, by label
  std::vector<std::vector<std::string>> option_lists{};  ///< as shown, each order once
  /// The words of the levels of a trial, by factor: each combination once.
  std::vector<std::map<std::string, std::uint32_t, std::less<>>> factor_levels{};
  std::vector<GatheredAnswer> answers{};  ///< by participant and session
  std::vector<FeltSurface> surfaces{};
  GatheredExploration exploration{};
  std::vector<GatheredReply> replies{};
  std::map<std::string, TextureForces> forces{};  ///< by model
  std::map<std::uint32_t, ItemTextureForce>
      item_forces{};  ///< by word of the item; none without a force
  /// From the recordings, by item; only for analyses that use them (needs_felt_octaves).
  std::map<std::string, FeltOctaves> felt_octaves{};
  std::size_t unread_recordings = 0;  ///< of attempts that count
  /// Of the blocks of this kind with `equal_roughness`, in the order of the sessions: those with an attempt that counts.
  std::vector<ParticipantMatch> matches{};
  /// By participant, block and type. No other number contains these responses.
  std::vector<CatchResponses> catch_responses{};
  /// By participant, session and trial. No other member contains these responses.
  std::vector<AnchorResponse> anchors{};
  /// With a recording of an attempt that counts which could be read; only for analyses that use them.
  std::size_t recorded_participants = 0;

  /// Whether responses are numbers that are analysed as the protocol's key `estimation` specifies.
  bool has_estimates() const noexcept { return !estimation.factor().empty(); }
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
  /// The word of the level of a factor in the trial of the answer; `kNoWord` in a trial without it.
  std::uint32_t level(const GatheredAnswer& answer, std::string_view factor) const;
  /// That of the factor whose levels are the columns of the chapter's tables.
  std::uint32_t column_of(const GatheredAnswer& answer) const {
    return level(answer, kColumnFactor);
  }
  /// The spacing of a magnitude in metres; nothing where its level is not a length and the protocol
  /// declares none.
  std::optional<double> spacing_m(const GatheredAnswer& answer) const;
};

/// The scale of a question; one with the ends that scales have by default for a question of another form.
const ScaleForm& scale_of(const Protocol::TrialQuestionTemplate& question);

/// By protocol, version, group and kind; empty ones are absent. With a `protocol`, only those of that
/// name. When `stop` is requested, only the sessions that were read until then.
std::vector<GatheredAnswers> gather_answers(const Study& study,
                                            const std::optional<std::string>& protocol,
                                            const std::stop_token& stop);

/// The same of some participants only.
std::vector<GatheredAnswers> gather_answers(
    const Study& study, const std::optional<std::string>& protocol,
    const std::function<bool(const ParticipantRow&)>& is_included, const std::stop_token& stop);

/// Gathers the responses of sessions that are in memory as `gather_answers` does those of a study, except for recordings.
class SessionGathering final {
 public:
  /// The stored protocol of all its sessions, which is read once. It must outlive the gatherings.
  struct OfProtocol {
    explicit OfProtocol(ProtocolRow of);
    ~OfProtocol();

    ProtocolRow row{};
    StoredProtocol specified{};
    struct Asked;
    std::unique_ptr<const Asked> asked;  ///< the questions by kind
  };

  explicit SessionGathering(const OfProtocol& protocol);
  ~SessionGathering();
  /// The sessions of a participant follow each other.
  void add(const ParticipantRow& participant, const SessionRow& session,
           const SessionAnswers& answers);
  /// By group and kind; empty ones are absent.
  std::vector<GatheredAnswers> finish() &&;

 private:
  struct Groups;
  const OfProtocol& protocol_;
  std::unique_ptr<Groups> groups_;
};

/// The response of a participant who does not choose, where the protocol allows it.
inline constexpr std::string_view kCannotTell = kCannotTellOption;

}  // namespace asperity
