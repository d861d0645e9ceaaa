// Reads sessions in order, the next one on a second thread, and adds each to the group of its protocol, kind and mode.

#include "app/findings/gathering/gathered_answers.h"

#include <algorithm>
#include <functional>
#include <future>
#include <optional>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "app/findings/gathering/gathered_session.h"
#include "app/findings/gathering/group_blocks.h"
#include "app/findings/gathering/questions_of_kind.h"
#include "protocols/design/protocol.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/groups.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

/// The matches of the trials with an attempt that counts.
std::vector<PresentedMatch> counted_matches(const Study& study, const SessionRow& session,
                                            const SessionAnswers& answers,
                                            const Protocol& protocol) {
  if (!presents_matches(protocol)) return {};
  std::set<int> counted{};
  for (const SessionAnswers::Attempt& attempt : answers.attempts) {
    if (attempt.use == AnalysisUse::counted) counted.insert(attempt.trial);
  }
  std::vector<PlannedTrialRow> trials = study.plan(session.id);
  std::erase_if(trials,
                [&counted](const PlannedTrialRow& row) { return !counted.contains(row.trial); });
  return presented_matches(protocol, trials);
}

/// The pictures of the questions in their order, then the levels of the factors.
std::vector<std::string> pictures_of(const Protocol& protocol) {
  std::vector<std::string> pictures{};
  for (const auto& [name, block] : protocol.blocks) {
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      pictures.insert(pictures.end(), question.pictures.begin(), question.pictures.end());
    }
  }
  for (const auto& [name, factor] : protocol.factors) {
    for (const Level& level : factor.levels) pictures.push_back(text_of(level));
  }
  return pictures;
}

/// Collects the responses of a group to questions of one kind from its sessions.
class Gathering {
 public:
  Gathering() { gathered.words.place(""); }

  GatheredAnswers gathered{};

  /// `questions`: those of this kind, by block. `group_block`: AnsweringPerson::block.
  void add_session(const SessionRow& session, const ParticipantRow& participant,
                   const SessionAnswers& answers, const QuestionsOfKind& questions,
                   const std::optional<std::string>& group_block) {
    participants_.insert(session.participant);
    gather_session({session, participant, answers, questions}, option_lists_, gathered);
    if (session.group_level && !gathered.people.empty() &&
        gathered.people.back().label == session.participant) {
      gathered.people.back().group = session.group_level;
      if (!gathered.people.back().block) gathered.people.back().block = group_block;
    }
  }

  /// A stimulus that several blocks present has one match.
  void add_matches(const SessionRow& session, std::vector<PresentedMatch> presented,
                   const QuestionsOfKind& questions) {
    std::erase_if(presented, [&questions](const PresentedMatch& match) {
      return !questions.has_block(match.block);
    });
    for (PresentedMatch& match : without_blocks(std::move(presented))) {
      gathered.matches.push_back({.participant = session.participant,
                                  .session = session.session,
                                  .match = std::move(match)});
    }
  }

  /// Recordings are large: they are read for a map of items, and for a magnitude over one of these properties.
  bool needs_felt_octaves() const {
    return gathered.kind == "similarity" ||
           std::find(kOctaveProperties.begin(), kOctaveProperties.end(),
                     gathered.estimation.predictor) != kOctaveProperties.end();
  }

  /// The recordings of the attempts that count.
  void add_recordings(const Study& study, const SessionRow& session, const SessionAnswers& answers,
                      const QuestionsOfKind& questions, const std::stop_token& stop) {
    std::set<int> asked{};
    for (const SessionAnswers::Trial& trial : answers.trials) {
      if (questions.has_block(answers.words[trial.block])) asked.insert(trial.trial);
    }
    std::vector<AttemptRow> rows = study.attempts(session.id);
    // The order of SessionAnswers::attempts.
    std::sort(rows.begin(), rows.end(), [](const AttemptRow& one, const AttemptRow& other) {
      return std::pair(one.trial, one.attempt) < std::pair(other.trial, other.attempt);
    });
    for (std::size_t i = 0; i < rows.size() && i < answers.attempts.size(); ++i) {
      if (stop.stop_requested()) return;
      const SessionAnswers::Attempt& attempt = answers.attempts[i];
      if (attempt.use != AnalysisUse::counted || !asked.contains(attempt.trial)) continue;
      try {
        add_felt_octaves(study, rows[i], gathered.felt_octaves);
        if (rows[i].recording) recorded_participants_.insert(session.participant);
      } catch (const ResultsError&) {
        ++gathered.unread_recordings;
      }
    }
  }

  /// `specified`: the stored protocol of the row.
  void declare(const ProtocolRow& protocol, const StoredProtocol& stored) {
    if (!sources_.insert(protocol.source_sha256).second) return;
    texts_of_sources_.push_back(protocol.source);
    const Protocol& specified = stored.protocol;
    for (const auto& [name, block] : specified.blocks) {
      if (block.phase != Phase::main) continue;
      for (const Protocol::TrialQuestionTemplate& question : block.questions) {
        if (kind_of_stored(protocol.kind, block, question) != gathered.kind) continue;
        gathered.blocks.try_emplace(name, block);
        gathered.surface_factors.try_emplace(name, stored.surface_factors.at(name));
        const bool is_known =
            std::any_of(gathered.questions.begin(), gathered.questions.end(),
                        [&question](const auto& known) { return known.name == question.name; });
        if (!is_known) gathered.questions.push_back(question);
        (kind_of_stored_block(protocol.kind, block) == gathered.kind ? has_own_questions_
                                                                     : has_accompanying_ones_) =
            true;
      }
    }
    const ExperimentKind* const kind = find_kind(gathered.kind);
    const bool has_numbers = kind == nullptr || std::holds_alternative<NumberForm>(kind->form);
    if (const auto& estimation = specified.estimation; estimation && has_numbers) {
      gathered.estimation.spacing = estimation->spacing;
      gathered.estimation.condition = estimation->condition;
      gathered.estimation.spacing_m.insert(estimation->spacing_m.begin(),
                                           estimation->spacing_m.end());
      gathered.estimation.items = estimation->items;
      gathered.estimation.item_levels = estimation->item_levels;
      gathered.estimation.predictor = estimation->predictor;
      gathered.estimation.predictor_unit = estimation->predictor_unit;
      gathered.estimation.predictor_values = estimation->predictor_values;
      gathered.estimation.modulus = estimation->modulus;
      gathered.estimation.stated_normalisation = estimation->stated_normalisation;
      std::vector<std::string>& conditions = gathered.estimation.conditions;
      for (const std::string& condition : estimation->conditions) {
        if (std::find(conditions.begin(), conditions.end(), condition) == conditions.end()) {
          conditions.push_back(condition);
        }
      }
    }
    if (gathered.group_factor.empty() && specified.groups) {
      gathered.group_factor = specified.groups->factor;
    }
    for (const std::string& group : groups_of(specified)) {
      if (std::find(gathered.groups.begin(), gathered.groups.end(), group) ==
          gathered.groups.end()) {
        gathered.groups.push_back(group);
      }
    }
    for (const std::string& picture : pictures_of(specified)) {
      std::vector<std::string>& known = gathered.pictures;
      if (std::find(known.begin(), known.end(), picture) == known.end()) {
        known.push_back(picture);
      }
    }
    if (sources_.size() == 1) {
      gathered.declared = specified.analysis;
      gathered.compared_parameter = stored.compared_parameter;
      return;
    }
    if (!(specified.analysis == gathered.declared)) gathered.declared_alike = false;
    if (stored.compared_parameter != gathered.compared_parameter) {
      gathered.compared_parameter.reset();
    }
  }

  GatheredAnswers finish() && {
    gathered.exploration.end_participant(gathered);
    std::erase_if(gathered.groups, [this](const std::string& group) {
      return std::none_of(gathered.people.begin(), gathered.people.end(),
                          [&group](const auto& person) { return person.group == group; });
    });
    gathered.count.participants = participants_.size();
    gathered.recorded_participants = recorded_participants_.size();
    gathered.only_accompanies = has_accompanying_ones_ && !has_own_questions_;
    // A single file does not have to be read again.
    gathered.sources = texts_of_sources_.size() < 2 ? texts_of_sources_.size()
                                                    : count_protocols(texts_of_sources_);
    if (!gathered.declared_alike) gathered.declared = {};
    return std::move(gathered);
  }

 private:
  std::set<std::string> participants_{};
  std::set<std::string> recorded_participants_{};
  std::set<std::string> sources_{};
  std::vector<std::string> texts_of_sources_{};
  OptionListPlaces option_lists_{};
  bool has_own_questions_ = false;
  bool has_accompanying_ones_ = false;
};

/// By name, version and group of the protocol, and by kind.
using Gatherings =
    std::map<std::tuple<std::string, std::string, AnswerGroup, std::string>, Gathering>;

/// The gathering of the responses of a session to the questions of a kind, which has its protocol declared.
Gathering& gathering_of(Gatherings& groups, const ProtocolRow& of, AnswerGroup group,
                        const std::string& kind, const StoredProtocol& specified) {
  Gathering& gathering = groups[std::tuple(of.name, of.version, group, kind)];
  gathering.gathered.protocol = of.name;
  gathering.gathered.version = of.version;
  gathering.gathered.title = specified.protocol.title;
  gathering.gathered.kind = kind;
  gathering.gathered.design = of.design;
  gathering.gathered.group = group;
  gathering.declare(of, specified);
  return gathering;
}

std::vector<GatheredAnswers> gathered_in(Gatherings groups) {
  std::vector<GatheredAnswers> all{};
  for (auto& [key, gathering] : groups) all.push_back(std::move(gathering).finish());
  return all;
}

/// Reads the responses of one session after another. In large studies most of the time of an
/// analysis is spent reading from SQLite: every other session is therefore read on a separate
/// thread, at the same time as the preceding one.
class AnswersInOrder final {
 public:
  AnswersInOrder(const Study& study, const std::vector<SessionRow>& sessions)
      : study_(study), sessions_(sessions) {
    // A second reader next to a writer in the same process is the caller's decision.
    if (study.access() == Access::read_only && sessions.size() > 1) {
      second_.emplace(Study::open(study.folder(), Access::read_only));
    }
  }

  SessionAnswers next() {
    const std::size_t own = next_++;
    if (ahead_.valid()) return ahead_.get();
    if (second_ && next_ < sessions_.size()) {
      try {
        ahead_ = std::async(std::launch::async, [this, id = sessions_[next_].id] {
          return second_->answers(id, AnswerParts::answers_and_exploration);
        });
      } catch (const std::system_error&) {
        second_.reset();  // no thread is available: reading on one thread takes longer
      }
    }
    return study_.answers(sessions_[own].id, AnswerParts::answers_and_exploration);
  }

 private:
  const Study& study_;
  const std::vector<SessionRow>& sessions_;
  std::optional<Study> second_{};  ///< used by one thread at a time
  std::size_t next_ = 0;
  /// Last member: its destructor waits before the members it uses are destroyed.
  std::future<SessionAnswers> ahead_{};
};

}  // namespace

const char* text_of(AnswerGroup group) noexcept {
  switch (group) {
    case AnswerGroup::people:
      return "people";
    case AnswerGroup::pilot:
      return "pilot";
    case AnswerGroup::virtual_participants:
      return "virtual";
  }
  return "";
}

AnswerGroup group_of(const ParticipantRow& participant, const SessionRow& session) {
  if (participant.is_virtual) return AnswerGroup::virtual_participants;
  return session.mode == SessionMode::pilot ? AnswerGroup::pilot : AnswerGroup::people;
}

std::string fate_of(AnalysisUse use, AttemptOutcome outcome) {
  if (use == AnalysisUse::excluded) return "excluded";
  // The participant responded, but the attempt does not count for a technical reason.
  return outcome == AttemptOutcome::answered ? "answered but invalid" : text_of(outcome);
}

std::uint32_t Words::place(const std::string& word) {
  const auto [found, is_new] = places_.try_emplace(word, static_cast<std::uint32_t>(words_.size()));
  if (is_new) words_.push_back(word);
  return found->second;
}

std::optional<std::uint32_t> Words::find(const std::string& word) const {
  const auto found = places_.find(word);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> GatheredAnswers::spacing_m(const GatheredAnswer& answer) const {
  const std::string& spacing = word(level(answer, estimation.spacing));
  const auto known = estimation.spacing_m.find(spacing);
  return known == estimation.spacing_m.end() ? number_in(spacing) : known->second;
}

std::uint32_t GatheredAnswers::level(const GatheredAnswer& answer, std::string_view factor) const {
  const auto& levels = factor_levels[answer.factors];
  const auto found = levels.find(factor);
  return found == levels.end() ? kNoWord : found->second;
}

const ScaleForm& scale_of(const Protocol::TrialQuestionTemplate& question) {
  static const ScaleForm kUnstated{};
  const auto* const scale = std::get_if<ScaleForm>(&question.form);
  return scale == nullptr ? kUnstated : *scale;
}

struct SessionGathering::OfProtocol::Asked {
  std::map<std::string, QuestionsOfKind> by_kind{};
};

SessionGathering::OfProtocol::OfProtocol(ProtocolRow of)
    : row(std::move(of)),
      specified(stored_protocol(row.source)),
      asked(std::make_unique<const Asked>(Asked{questions_by_kind(specified.protocol, row.kind)})) {
}

SessionGathering::OfProtocol::~OfProtocol() = default;

std::vector<GatheredAnswers> gather_answers(const Study& study,
                                            const std::optional<std::string>& protocol,
                                            const std::stop_token& stop) {
  return gather_answers(
      study, protocol, [](const ParticipantRow&) { return true; }, stop);
}

std::vector<GatheredAnswers> gather_answers(
    const Study& study, const std::optional<std::string>& protocol,
    const std::function<bool(const ParticipantRow&)>& is_included, const std::stop_token& stop) {
  Gatherings groups{};
  std::map<std::int64_t, ProtocolRow> protocols{};
  std::map<std::int64_t, SessionGathering::OfProtocol>
      read{};  ///< those of the sessions, each once
  for (ProtocolRow& row : study.protocols()) protocols.emplace(row.id, std::move(row));
  std::map<std::string, ParticipantRow> participants{};
  for (ParticipantRow& row : study.participants()) participants.emplace(row.label, std::move(row));
  std::vector<SessionRow> sessions = study.sessions();
  const std::vector<SessionRow> all_sessions = sessions;
  GroupBlocks blocks(study, all_sessions);
  std::erase_if(sessions, [&](const SessionRow& session) {
    return session.withdrawn || !is_included(participants.at(session.participant));
  });
  if (protocol) {
    std::erase_if(sessions, [&](const SessionRow& session) {
      return protocols.at(session.protocol_id).name != *protocol;
    });
  }
  AnswersInOrder answers(study, sessions);
  for (const SessionRow& session : sessions) {
    if (stop.stop_requested()) break;
    const ProtocolRow& of = protocols.at(session.protocol_id);
    const ParticipantRow& participant = participants.at(session.participant);
    const AnswerGroup group = group_of(participant, session);
    const SessionAnswers given = answers.next();
    const SessionGathering::OfProtocol& protocol_read = read.try_emplace(of.id, of).first->second;
    const StoredProtocol& specified = protocol_read.specified;
    const std::vector<PresentedMatch> matches =
        counted_matches(study, session, given, specified.protocol);
    const std::optional<std::string> block = blocks.of(session, specified.protocol);
    for (const auto& [kind, questions] : protocol_read.asked->by_kind) {
      Gathering& gathering = gathering_of(groups, of, group, kind, specified);
      gathering.add_session(session, participant, given, questions, block);
      if (gathering.needs_felt_octaves()) {
        gathering.add_recordings(study, session, given, questions, stop);
      }
      gathering.add_matches(session, matches, questions);
    }
  }
  return gathered_in(std::move(groups));
}

struct SessionGathering::Groups {
  Gatherings by_key{};
};

SessionGathering::SessionGathering(const OfProtocol& protocol)
    : protocol_(protocol), groups_(std::make_unique<Groups>()) {}

SessionGathering::~SessionGathering() = default;

void SessionGathering::add(const ParticipantRow& participant, const SessionRow& session,
                           const SessionAnswers& answers) {
  const AnswerGroup group = group_of(participant, session);
  for (const auto& [kind, questions] : protocol_.asked->by_kind) {
    gathering_of(groups_->by_key, protocol_.row, group, kind, protocol_.specified)
        .add_session(session, participant, answers, questions,
                     block_of_simulated(participant.label, protocol_.specified.protocol));
  }
}

std::vector<GatheredAnswers> SessionGathering::finish() && {
  return gathered_in(std::move(groups_->by_key));
}

}  // namespace asperity
