// Follows the attempts of a session; words are looked up once for each session.

#include "app/findings/gathering/gathered_session.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/records/session_conditions.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/plan.h"
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

/// Adds the attempts of a session to its group. Its indices of words are those of the group as far as it has them.
class GatheredSession final {
 public:
  GatheredSession(const SessionToGather& session, OptionListPlaces& option_lists,
                  GatheredAnswers& gathered)
      : row_(session.row),
        participant_(session.participant),
        answers_(session.answers),
        questions_(session.questions),
        option_lists_(option_lists),
        gathered_(gathered),
        words_(answers_.words.size()),
        options_(words_),
        factors_(words_) {}

  void add() {
    std::map<int, const SessionAnswers::Trial*> planned{};
    std::map<int, int> first_of_block{};  ///< the trial, by the ordinal of the block
    for (const SessionAnswers::Trial& trial : answers_.trials) {
      first_of_block.try_emplace(trial.block_ordinal, trial.trial);
      if (!questions_.has_block(answers_.words[trial.block])) continue;
      planned[trial.trial] = &trial;
      if (trial.use == AnalysisUse::counted) ++gathered_.count.planned_trials;
    }
    for (const SessionAnswers::Attempt& attempt : answers_.attempts) {
      const auto found = planned.find(attempt.trial);
      if (found == planned.end()) continue;
      const SessionAnswers::Trial& trial = *found->second;
      switch (attempt.use) {
        case AnalysisUse::practice:
          break;
        case AnalysisUse::anchor:
          if (attempt.valid && attempt.replies > 0) ++gathered_.count.anchors;
          if (attempt.valid && !attempt.excluded) add_anchor(attempt, trial);
          break;
        case AnalysisUse::catch_trial:
          if (attempt.valid && !attempt.excluded) add_catch_response(attempt, trial);
          break;
        case AnalysisUse::invalid:
        case AnalysisUse::unanswered:
        case AnalysisUse::excluded:
          ++gathered_.count.not_counted[fate_of(attempt.use, attempt.outcome)];
          break;
        case AnalysisUse::counted:
          if (attempt.flagged) ++gathered_.count.flagged;
          add_answers(attempt, person(), trial,
                      attempt.trial - first_of_block[trial.block_ordinal] + 1);
          break;
      }
    }
  }

 private:
  /// The replies to one question that was asked, which stand together.
  struct RepliesToQuestion {
    std::uint32_t question = 0;
    std::span<const SessionAnswers::Reply> replies{};
  };

  std::uint32_t word(std::uint32_t place) {
    std::optional<std::uint32_t>& own = words_[place];
    if (!own) own = gathered_.words.place(answers_.words[place]);
    return *own;
  }

  std::uint32_t factors(std::uint32_t factors_json) {
    std::optional<std::uint32_t>& own = factors_[factors_json];
    if (own) return *own;
    own = static_cast<std::uint32_t>(gathered_.factor_levels.size());
    auto& levels = gathered_.factor_levels.emplace_back();
    const auto stored = stored_json(answers_.words[factors_json], "trial.factors_json");
    for (const auto& [factor, level] : stored.items()) {
      levels[factor] = gathered_.words.place(
          level.is_string() ? level.get<std::string>() : text_of_number(level.get<double>()));
    }
    return *own;
  }

  std::uint32_t options(std::uint32_t options_json) {
    std::optional<std::uint32_t>& own = options_[options_json];
    if (own) return *own;
    const std::string& text = answers_.words[options_json];
    const auto [known, is_new] =
        option_lists_.try_emplace(text, static_cast<std::uint32_t>(gathered_.option_lists.size()));
    if (is_new) {
      gathered_.option_lists.push_back(
          stored_json(text, "response.options_json").get<std::vector<std::string>>());
    }
    own = known->second;
    return *own;
  }

  std::uint32_t person() {
    if (gathered_.people.empty() || gathered_.people.back().label != participant_.label) {
      gathered_.exploration.end_participant(gathered_);
      gathered_.people.push_back({participant_.label, participant_.sex});
    }
    return static_cast<std::uint32_t>(gathered_.people.size() - 1);
  }

  std::vector<RepliesToQuestion> replies_by_question(const SessionAnswers::Attempt& attempt,
                                                     const std::string& block) const {
    const auto all = answers_.replies_of(attempt);
    std::vector<RepliesToQuestion> found{};
    for (std::size_t from = 0; from < all.size();) {
      std::size_t to = from + 1;
      while (to < all.size() && all[to].question == all[from].question) ++to;
      if (all[from].was_asked && questions_.has(block, answers_.words[all[from].question])) {
        found.push_back({all[from].question, all.subspan(from, to - from)});
      }
      from = to;
    }
    return found;
  }

  /// Nothing in a block of this kind. Of the questions of other kinds a block has one.
  std::optional<AccompaniedResponse> accompanied_response(const SessionAnswers::Attempt& attempt,
                                                          const std::string& block) {
    if (!questions_.accompanied.contains(block)) return std::nullopt;
    AccompaniedResponse response{};
    std::size_t items = 0;
    for (const SessionAnswers::Reply& reply : answers_.replies_of(attempt)) {
      const std::string& question = answers_.words[reply.question];
      if (questions_.has(block, question)) continue;
      if (questions_.is_additional(block, question)) continue;
      if (!reply.was_asked) continue;
      response.question = word(reply.question);
      response.answer = ++items == 1 && !reply.number ? word(reply.answer) : kNoWord;
      if (reply.correct) response.correct = response.correct.value_or(true) && *reply.correct;
    }
    return response;
  }

  /// Nothing in a block without a rating of confidence.
  std::optional<double> confidence_in(const SessionAnswers::Attempt& attempt,
                                      const std::string& block) const {
    const auto scale = questions_.confidences.find(block);
    if (scale == questions_.confidences.end()) return std::nullopt;
    for (const SessionAnswers::Reply& reply : answers_.replies_of(attempt)) {
      if (answers_.words[reply.question] == scale->second) return reply.number;
    }
    return std::nullopt;
  }

  /// `place`: of the trial in the run of its block.
  void add_answers(const SessionAnswers::Attempt& attempt, std::uint32_t person,
                   const SessionAnswers::Trial& planned, int place) {
    const std::string& block = answers_.words[planned.block];
    const auto by_question = replies_by_question(attempt, block);
    if (by_question.empty()) return;
    const std::size_t first_surface = gathered_.surfaces.size();
    const auto surfaces = answers_.surfaces_of(attempt);
    for (const SessionAnswers::Surface& surface : surfaces) add_surface(surface);
    gathered_.exploration.add(answers_.explorations_of(attempt));
    const std::uint32_t levels = factors(planned.factors_json);
    const auto accompanied = accompanied_response(attempt, block);
    const auto confidence = confidence_in(attempt, block);
    for (const RepliesToQuestion& to : by_question) {
      const std::optional<double>& time_s = to.replies.back().from_cue_s;
      gathered_.answers.push_back({.person = person,
                                   .block = word(planned.block),
                                   .question = word(to.question),
                                   .factors = levels,
                                   .options = options(to.replies.back().options_json),
                                   .repetition = planned.repetition,
                                   .session = row_.session,
                                   .block_ordinal = planned.block_ordinal,
                                   .trial_of_block = place,
                                   .track = planned.track.value_or(0),
                                   .step = planned.step.value_or(0),
                                   .continues_trial = &to != by_question.data(),
                                   .session_is_unfinished = row_.state != SessionState::completed,
                                   .response_time_s = time_s > 0.0 ? time_s : std::nullopt,
                                   .accompanied = accompanied,
                                   .confidence = confidence,
                                   .surface_count = static_cast<std::uint16_t>(surfaces.size()),
                                   .reply_count = static_cast<std::uint16_t>(to.replies.size()),
                                   .first_surface = first_surface,
                                   .first_reply = gathered_.replies.size()});
      for (const SessionAnswers::Reply& reply : to.replies) {
        gathered_.replies.push_back({word(reply.answer), reply.correct, reply.number});
      }
    }
  }

  void add_anchor(const SessionAnswers::Attempt& attempt, const SessionAnswers::Trial& trial) {
    const AnchorResponse of{.participant = row_.participant,
                            .session = row_.session,
                            .block_ordinal = trial.block_ordinal,
                            .block = answers_.words[trial.block],
                            .place = anchor_place_in(stored_json(
                                answers_.anchor_plans.at(trial.trial), "trial.plan_json"))};
    for (const RepliesToQuestion& to : replies_by_question(attempt, of.block)) {
      AnchorResponse& response = gathered_.anchors.emplace_back(of);
      response.question = answers_.words[to.question];
      if (to.replies.size() == 1) response.number = to.replies.front().number;
      std::size_t judged = 0;
      std::size_t correct = 0;
      for (const SessionAnswers::Reply& reply : to.replies) {
        const std::string& answer = answers_.words[reply.answer];
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
  CatchType type_of_catch_trial(const SessionAnswers::Attempt& attempt,
                                const std::string& block) const {
    const auto surfaces = answers_.surfaces_of(attempt);
    const bool has_comparison =
        std::any_of(surfaces.begin(), surfaces.end(), [this](const auto& surface) {
          return answers_.words[surface.item].starts_with("comparison");
        });
    if (surfaces.empty() || has_comparison) return CatchType::easy;
    const auto known = gathered_.blocks.find(block);
    const bool is_performance =
        known != gathered_.blocks.end() &&
        std::any_of(known->second.questions.begin(), known->second.questions.end(),
                    [](const auto& question) {
                      return question.judgement() == DiscriminationJudgement::performance;
                    });
    return is_performance ? CatchType::no_signal : CatchType::identical_pair;
  }

  /// Correct where there is a response, and none is incorrect.
  void add_catch_response(const SessionAnswers::Attempt& attempt,
                          const SessionAnswers::Trial& trial) {
    const std::string& block = answers_.words[trial.block];
    const CatchType type = type_of_catch_trial(attempt, block);
    auto& all = gathered_.catch_responses;
    auto known = std::find_if(all.begin(), all.end(), [&](const CatchResponses& each) {
      return each.participant == row_.participant && each.block == block && each.type == type;
    });
    if (known == all.end()) {
      known = all.insert(known, {.participant = row_.participant, .block = block, .type = type});
    }
    ++known->trials;
    const auto replies = answers_.replies_of(attempt);
    const bool is_correct =
        !replies.empty() && std::all_of(replies.begin(), replies.end(), [](const auto& reply) {
          return reply.correct.value_or(true);
        });
    if (is_correct) ++known->correct;
  }

  void add_surface(const SessionAnswers::Surface& surface) {
    gathered_.surfaces.push_back({word(surface.item), word(surface.texture)});
    TextureForces& forces = gathered_.forces[answers_.words[surface.model]];
    ++forces.surfaces;
    if (surface.matched_texture_force_N) {
      forces.matched_N.push_back(*surface.matched_texture_force_N);
    }
    if (surface.achieved_texture_force_N) {
      forces.achieved_N.push_back(*surface.achieved_texture_force_N);
      ItemTextureForce& of_item = gathered_.item_forces[gathered_.surfaces.back().item];
      ++of_item.surfaces;
      of_item.sum_N += *surface.achieved_texture_force_N;
    }
  }

  const SessionRow& row_;
  const ParticipantRow& participant_;
  const SessionAnswers& answers_;
  const QuestionsOfKind& questions_;
  OptionListPlaces& option_lists_;
  GatheredAnswers& gathered_;
  std::vector<std::optional<std::uint32_t>> words_;
  std::vector<std::optional<std::uint32_t>>
      options_;  ///< of option lists, by the word of their JSON
  std::vector<std::optional<std::uint32_t>> factors_;  ///< of levels, by the word of their JSON
};

}  // namespace

void gather_session(const SessionToGather& session, OptionListPlaces& option_lists,
                    GatheredAnswers& gathered) {
  AnswerCount& count = gathered.count;
  ++count.sessions;
  if (session.row.state != SessionState::completed) ++count.unfinished_sessions;
  if (is_guessing(session.row, gathered.kind)) ++count.guessing_sessions;
  if (!session.participant.is_virtual && is_unfelt(session.row)) ++count.unfelt_sessions;
  GatheredSession(session, option_lists, gathered).add();
}

}  // namespace asperity
