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

#include <nlohmann/json.hpp>

#include "app/findings/gathering/group_blocks.h"
#include "app/findings/gathering/questions_of_kind.h"
#include "app/records/session_conditions.h"
#include "protocols/design/protocol.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/groups.h"
#include "protocols/plan/plan.h"
#include "protocols/plan/roughness_matching.h"
#include "results_schema/stored_json.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

/// Whether the observer's responses are declared to be guesses. Numbers require no expectation.
bool is_guessing(const SessionRow& session, const std::string& kind) {
  const nlohmann::json observer = stored_json(session.observer_json, "session.observer_json");
  if (!observer.is_object()) return false;
  const ExperimentKind* const known = find_kind(kind);
  const bool needs_expectation = known == nullptr || known->has_expectations;
  return observer.value("deaf", false) ||
         (needs_expectation && observer.value("expectation", "") == "none");
}

/// Whether the stored device shows that participants could not feel the surfaces.
bool is_unfelt(const SessionRow& session) {
  const RecordedDevice device = recorded_device(session.device, session.device_json);
  return device.has_motors == false || !device.hand_of_program().empty();
}

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
    ++gathered.count.sessions;
    if (session.state != SessionState::completed) ++gathered.count.unfinished_sessions;
    if (is_guessing(session, gathered.kind)) ++gathered.count.guessing_sessions;
    if (!participant.is_virtual && is_unfelt(session)) ++gathered.count.unfelt_sessions;
    participants_.insert(session.participant);
    Session reading{.session = session.session,
                    .is_unfinished = session.state != SessionState::completed,
                    .answers = answers,
                    .questions = questions,
                    .words = std::vector<std::optional<std::uint32_t>>(answers.words.size())};
    reading.options = reading.factors = reading.words;
    std::map<int, const SessionAnswers::Trial*> planned{};
    std::map<int, int> first_of_block{};  ///< the trial, by the ordinal of the block
    for (const SessionAnswers::Trial& trial : answers.trials) {
      first_of_block.try_emplace(trial.block_ordinal, trial.trial);
      if (!reading.asks(trial)) continue;
      planned[trial.trial] = &trial;
      if (trial.use == AnalysisUse::counted) ++gathered.count.planned_trials;
    }
    for (const SessionAnswers::Attempt& attempt : answers.attempts) {
      const auto trial = planned.find(attempt.trial);
      if (trial == planned.end()) continue;
      switch (attempt.use) {
        case AnalysisUse::practice:
          break;
        case AnalysisUse::anchor:
          if (attempt.valid && attempt.replies > 0) ++gathered.count.anchors;
          if (attempt.valid && !attempt.excluded) {
            add_anchor(reading, attempt, *trial->second, session.participant);
          }
          break;
        case AnalysisUse::catch_trial:
          if (attempt.valid && !attempt.excluded) {
            add_catch_response({.participant = session.participant,
                                .block = answers.words[trial->second->block],
                                .type = type_of_catch_trial(reading, *trial->second, attempt)},
                               answers.replies_of(attempt));
          }
          break;
        case AnalysisUse::invalid:
        case AnalysisUse::unanswered:
        case AnalysisUse::excluded:
          ++gathered.count.not_counted[fate_of(attempt.use, attempt.outcome)];
          break;
        case AnalysisUse::counted:
          if (attempt.flagged) ++gathered.count.flagged;
          add_answers(reading, attempt, person(participant),
                      {.trial = *trial->second,
                       .place = attempt.trial - first_of_block[trial->second->block_ordinal] + 1});
          break;
      }
    }
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
  /// A session's indices of words, as far as the group has them.
  struct Session {
    int session = 1;  ///< ordinal within the participant
    bool is_unfinished = false;
    const SessionAnswers& answers;
    const QuestionsOfKind& questions;
    std::vector<std::optional<std::uint32_t>> words{};
    /// Indices of option lists, by the word of their JSON.
    std::vector<std::optional<std::uint32_t>> options{};
    /// Indices of levels, by the word of their JSON.
    std::vector<std::optional<std::uint32_t>> factors{};

    bool asks(const SessionAnswers::Trial& trial) const {
      return questions.has_block(answers.words[trial.block]);
    }
  };

  std::uint32_t word(Session& session, std::uint32_t place) {
    std::optional<std::uint32_t>& own = session.words[place];
    if (!own) own = gathered.words.place(session.answers.words[place]);
    return *own;
  }

  std::uint32_t factors(Session& session, std::uint32_t factors_json) {
    std::optional<std::uint32_t>& own = session.factors[factors_json];
    if (own) return *own;
    own = static_cast<std::uint32_t>(gathered.factor_levels.size());
    auto& levels = gathered.factor_levels.emplace_back();
    const auto stored = stored_json(session.answers.words[factors_json], "trial.factors_json");
    for (const auto& [factor, level] : stored.items()) {
      levels[factor] = gathered.words.place(
          level.is_string() ? level.get<std::string>() : text_of_number(level.get<double>()));
    }
    return *own;
  }

  std::uint32_t options(Session& session, std::uint32_t options_json) {
    std::optional<std::uint32_t>& own = session.options[options_json];
    if (own) return *own;
    const std::string& text = session.answers.words[options_json];
    const auto [known, is_new] =
        option_lists_.try_emplace(text, static_cast<std::uint32_t>(gathered.option_lists.size()));
    if (is_new) {
      gathered.option_lists.push_back(
          stored_json(text, "response.options_json").get<std::vector<std::string>>());
    }
    own = known->second;
    return *own;
  }

  std::uint32_t person(const ParticipantRow& participant) {
    if (gathered.people.empty() || gathered.people.back().label != participant.label) {
      gathered.exploration.end_participant(gathered);
      gathered.people.push_back({participant.label, participant.sex});
    }
    return static_cast<std::uint32_t>(gathered.people.size() - 1);
  }

  /// The replies to one question that was asked, which stand together.
  struct RepliesToQuestion {
    std::uint32_t question = 0;
    std::span<const SessionAnswers::Reply> replies{};
  };
  std::vector<RepliesToQuestion> replies_by_question(const Session& session,
                                                     const SessionAnswers::Attempt& attempt,
                                                     const std::string& block) const {
    const auto all = session.answers.replies_of(attempt);
    std::vector<RepliesToQuestion> found{};
    for (std::size_t from = 0; from < all.size();) {
      std::size_t to = from + 1;
      while (to < all.size() && all[to].question == all[from].question) ++to;
      if (all[from].was_asked &&
          session.questions.has(block, session.answers.words[all[from].question])) {
        found.push_back({all[from].question, all.subspan(from, to - from)});
      }
      from = to;
    }
    return found;
  }

  /// Nothing in a block of this kind. Of the questions of other kinds a block has one.
  std::optional<AccompaniedResponse> accompanied_response(Session& session,
                                                          const SessionAnswers::Attempt& attempt,
                                                          const std::string& block) {
    if (!session.questions.accompanied.contains(block)) return std::nullopt;
    AccompaniedResponse response{};
    std::size_t items = 0;
    for (const SessionAnswers::Reply& reply : session.answers.replies_of(attempt)) {
      const std::string& question = session.answers.words[reply.question];
      if (session.questions.has(block, question)) continue;
      if (session.questions.is_additional(block, question)) continue;
      if (!reply.was_asked) continue;
      response.question = word(session, reply.question);
      response.answer = ++items == 1 && !reply.number ? word(session, reply.answer) : kNoWord;
      if (reply.correct) response.correct = response.correct.value_or(true) && *reply.correct;
    }
    return response;
  }

  /// Nothing in a block without a rating of confidence.
  static std::optional<double> confidence_in(const Session& session,
                                             const SessionAnswers::Attempt& attempt,
                                             const std::string& block) {
    const auto scale = session.questions.confidences.find(block);
    if (scale == session.questions.confidences.end()) return std::nullopt;
    for (const SessionAnswers::Reply& reply : session.answers.replies_of(attempt)) {
      if (session.answers.words[reply.question] == scale->second) return reply.number;
    }
    return std::nullopt;
  }

  struct PlannedTrial {
    const SessionAnswers::Trial& trial;
    int place = 1;  ///< in the run of its block
  };

  void add_answers(Session& session, const SessionAnswers::Attempt& attempt, std::uint32_t person,
                   const PlannedTrial& of_plan) {
    const SessionAnswers::Trial& planned = of_plan.trial;
    const std::string& block = session.answers.words[planned.block];
    const auto by_question = replies_by_question(session, attempt, block);
    if (by_question.empty()) return;
    const std::size_t first_surface = gathered.surfaces.size();
    const auto surfaces = session.answers.surfaces_of(attempt);
    for (const SessionAnswers::Surface& surface : surfaces) add_surface(session, surface);
    gathered.exploration.add(session.answers.explorations_of(attempt));
    const std::uint32_t levels = factors(session, planned.factors_json);
    const auto accompanied = accompanied_response(session, attempt, block);
    const auto confidence = confidence_in(session, attempt, block);
    for (const RepliesToQuestion& to : by_question) {
      const std::optional<double>& time_s = to.replies.back().from_cue_s;
      gathered.answers.push_back({.person = person,
                                  .block = word(session, planned.block),
                                  .question = word(session, to.question),
                                  .factors = levels,
                                  .options = options(session, to.replies.back().options_json),
                                  .repetition = planned.repetition,
                                  .session = session.session,
                                  .block_ordinal = planned.block_ordinal,
                                  .trial_of_block = of_plan.place,
                                  .track = planned.track.value_or(0),
                                  .step = planned.step.value_or(0),
                                  .continues_trial = &to != by_question.data(),
                                  .session_is_unfinished = session.is_unfinished,
                                  .response_time_s = time_s > 0.0 ? time_s : std::nullopt,
                                  .accompanied = accompanied,
                                  .confidence = confidence,
                                  .surface_count = static_cast<std::uint16_t>(surfaces.size()),
                                  .reply_count = static_cast<std::uint16_t>(to.replies.size()),
                                  .first_surface = first_surface,
                                  .first_reply = gathered.replies.size()});
      for (const SessionAnswers::Reply& reply : to.replies) {
        gathered.replies.push_back({word(session, reply.answer), reply.correct, reply.number});
      }
    }
  }

  void add_anchor(const Session& session, const SessionAnswers::Attempt& attempt,
                  const SessionAnswers::Trial& trial, const std::string& participant) {
    const AnchorResponse of{.participant = participant,
                            .session = session.session,
                            .block_ordinal = trial.block_ordinal,
                            .block = session.answers.words[trial.block],
                            .place = anchor_place_in(stored_json(
                                session.answers.anchor_plans.at(trial.trial), "trial.plan_json"))};
    for (const RepliesToQuestion& to : replies_by_question(session, attempt, of.block)) {
      AnchorResponse& response = gathered.anchors.emplace_back(of);
      response.question = session.answers.words[to.question];
      if (to.replies.size() == 1) response.number = to.replies.front().number;
      std::size_t judged = 0;
      std::size_t correct = 0;
      for (const SessionAnswers::Reply& reply : to.replies) {
        const std::string& answer = session.answers.words[reply.answer];
        response.answer += (response.answer.empty() ? "" : ", ") + answer;
        judged += reply.correct ? 1U : 0U;
        correct += reply.correct.value_or(false) ? 1U : 0U;
      }
      if (judged > 0) {
        response.correct = static_cast<double>(correct) / static_cast<double>(judged);
      }
    }
  }

  /// Of the surfaces that the attempt presented: without a comparison, it is not an easy one.
  CatchType type_of_catch_trial(const Session& session, const SessionAnswers::Trial& trial,
                                const SessionAnswers::Attempt& attempt) const {
    const auto surfaces = session.answers.surfaces_of(attempt);
    const bool has_comparison =
        std::any_of(surfaces.begin(), surfaces.end(), [&session](const auto& surface) {
          return session.answers.words[surface.item].starts_with("comparison");
        });
    if (surfaces.empty() || has_comparison) return CatchType::easy;
    const auto block = gathered.blocks.find(session.answers.words[trial.block]);
    const bool is_performance =
        block != gathered.blocks.end() &&
        std::any_of(block->second.questions.begin(), block->second.questions.end(),
                    [](const auto& question) {
                      return question.judgement() == DiscriminationJudgement::performance;
                    });
    return is_performance ? CatchType::no_signal : CatchType::identical_pair;
  }

  /// `of`: without counts. Correct where there is a response, and none is incorrect.
  void add_catch_response(CatchResponses of, std::span<const SessionAnswers::Reply> replies) {
    auto& all = gathered.catch_responses;
    auto known = std::find_if(all.begin(), all.end(), [&](const CatchResponses& each) {
      return each.participant == of.participant && each.block == of.block && each.type == of.type;
    });
    if (known == all.end()) known = all.insert(known, std::move(of));
    ++known->trials;
    const bool is_correct =
        !replies.empty() && std::all_of(replies.begin(), replies.end(), [](const auto& reply) {
          return reply.correct.value_or(true);
        });
    if (is_correct) ++known->correct;
  }

  void add_surface(Session& session, const SessionAnswers::Surface& surface) {
    gathered.surfaces.push_back({word(session, surface.item), word(session, surface.texture)});
    TextureForces& forces = gathered.forces[session.answers.words[surface.model]];
    ++forces.surfaces;
    if (surface.matched_texture_force_N) {
      forces.matched_N.push_back(*surface.matched_texture_force_N);
    }
    if (surface.achieved_texture_force_N) {
      forces.achieved_N.push_back(*surface.achieved_texture_force_N);
      ItemTextureForce& of_item = gathered.item_forces[gathered.surfaces.back().item];
      ++of_item.surfaces;
      of_item.sum_N += *surface.achieved_texture_force_N;
    }
  }

  std::set<std::string> participants_{};
  std::set<std::string> recorded_participants_{};
  std::set<std::string> sources_{};
  std::vector<std::string> texts_of_sources_{};
  std::map<std::string, std::uint32_t> option_lists_{};
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
  struct ReadProtocol {
    StoredProtocol specified{};
    std::map<std::string, QuestionsOfKind> asked{};
  };
  std::map<std::int64_t, ReadProtocol> read{};  ///< those of the sessions, each once
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
    const auto [found, is_new] = read.try_emplace(of.id);
    if (is_new) {
      found->second.specified = stored_protocol(of.source);
      found->second.asked = questions_by_kind(found->second.specified.protocol, of.kind);
    }
    const std::vector<PresentedMatch> matches =
        counted_matches(study, session, given, found->second.specified.protocol);
    const std::optional<std::string> block = blocks.of(session, found->second.specified.protocol);
    for (const auto& [kind, questions] : found->second.asked) {
      Gathering& gathering = gathering_of(groups, of, group, kind, found->second.specified);
      gathering.add_session(session, participant, given, questions, block);
      if (gathering.needs_felt_octaves()) {
        gathering.add_recordings(study, session, given, questions, stop);
      }
      gathering.add_matches(session, matches, questions);
    }
  }
  return gathered_in(std::move(groups));
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
