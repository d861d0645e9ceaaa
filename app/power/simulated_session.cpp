// Follows the course of a session trial by trial, with random numbers that belong to the trial.

#include "app/power/simulated_session.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "protocols/design/block_factors.h"
#include "protocols/plan/course.h"
#include "protocols/plan/shown_options.h"

namespace asperity {

namespace {

using QuestionTables = std::vector<PowerTables::OfQuestion>;

/// Collects the responses of a session.
class AnswersOfSession final {
 public:
  std::uint32_t word(const std::string& text) {
    const auto [found, is_new] =
        places_.try_emplace(text, static_cast<std::uint32_t>(answers_.words.size()));
    if (is_new) answers_.words.push_back(text);
    return found->second;
  }

  AnalysisUse add_trial(const Trial& trial) {
    const AnalysisUse use =
        use_in_analyses(text_of(trial.phase), trial.repetition, trial.catch_trial.has_value());
    SessionAnswers::Trial planned{.trial = trial.ordinal,
                                  .use = use,
                                  .block = word(trial.block),
                                  .factors_json = word(factors_json_of(trial)),
                                  .repetition = trial.repetition,
                                  .block_ordinal = trial.block_ordinal};
    if (trial.track) {
      planned.track = trial.track->track;
      planned.step = trial.track->step;
    }
    answers_.trials.push_back(planned);
    return use;
  }

  void begin_attempt(const Trial& trial, AnalysisUse use) {
    answers_.attempts.push_back({.trial = trial.ordinal,
                                 .use = use,
                                 .first_surface = answers_.surfaces.size(),
                                 .surfaces = trial.presentations.size(),
                                 .first_reply = answers_.replies.size()});
    for (const PlannedPresentation& surface : trial.presentations) {
      answers_.surfaces.push_back({.position = surface.position,
                                   .item = word(surface.item),
                                   .model = word(surface.stimulus.model),
                                   .texture = word(surface.stimulus.texture)});
    }
  }

  void add_replies(const Question& question, const std::vector<AnsweredItem>& items) {
    const std::uint32_t shown = word(options_json_of(question));
    for (const AnsweredItem& item : items) {
      answers_.replies.push_back({.question = word(question.name),
                                  .item = item.item,
                                  .answer = word(item.answer),
                                  .options_json = shown,
                                  .correct = item.correct,
                                  .number = item.number});
    }
    answers_.attempts.back().replies += items.size();
  }

  SessionAnswers take() { return std::move(answers_); }

 private:
  SessionAnswers answers_{};
  std::unordered_map<std::string, std::uint32_t> places_{};
};

/// Whether all items of a response are correct; nothing where none is correct or incorrect.
std::optional<bool> all_correct(const std::vector<AnsweredItem>& items) {
  std::optional<bool> correct{};
  for (const AnsweredItem& item : items) {
    if (item.correct) correct = correct.value_or(true) && *item.correct;
  }
  return correct;
}

using ItemsByQuestion = std::map<std::string, std::vector<AnsweredItem>, std::less<>>;

/// The responses to all questions of a trial. Those of other kinds depend on whether the response to that of the block's kind
/// is correct.
ItemsByQuestion responses_to(const SimulatedSessionInputs& inputs, const Trial& trial,
                             const QuestionTables& tables) {
  const Random of_trial =
      inputs.of_session.split("trial").split(static_cast<std::uint64_t>(trial.ordinal));
  ItemsByQuestion given{};
  std::optional<bool> is_correct{};
  for (const bool is_of_block : {true, false}) {
    for (const PowerTables::OfQuestion& of : tables) {
      if (of.tabulated->is_of_block != is_of_block) continue;
      const TabulatedQuestion& asked = of.tabulated->asked;
      const std::string& name = asked.question.name;
      const Question* const question = find_question(trial, name);
      if (question == nullptr) continue;
      if (question->condition) {
        const auto needed = given.find(question->condition->question);
        if (needed == given.end() || !is_met(*question->condition, texts_of(needed->second))) {
          continue;
        }
      }
      const Answer answer =
          of.tabulated->table->respond({.asked = asked,
                                        .trial = trial,
                                        .question = *question,
                                        .values = of.values,
                                        .of_study = inputs.of_study.split(name),
                                        .of_participant = inputs.of_participant.split(name),
                                        .of_response = of_trial.split(name),
                                        .is_correct = is_of_block ? std::nullopt : is_correct});
      std::vector<AnsweredItem>& items = given[name] = items_of(*question, answer);
      if (is_of_block) is_correct = all_correct(items);
    }
  }
  return given;
}

/// What the responses mean for the procedure that chose the level of the trial.
TrialOutcome outcome_of_responses(const Protocol::Block& block, const Trial& trial,
                                  const ItemsByQuestion& given) {
  const auto* const judged = judged_question(block);
  if (trial.catch_trial || judged == nullptr || !block.vary) return {};
  const auto varied =
      std::find_if(trial.presentations.begin(), trial.presentations.end(),
                   [&block](const auto& surface) { return surface.role == block.vary->role; });
  const auto response = given.find(judged->name);
  if (varied == trial.presentations.end() || response == given.end()) return {};
  return {.answer = TrialOutcome::Answer{
              .value = std::get<double>(trial.factors.at(block.vary->factor)),
              .outcome = level_outcome_of(block, *judged, varied->item, response->second.front())}};
}

}  // namespace

SessionAnswers simulated_session(const SimulatedSessionInputs& inputs) {
  const Protocol& protocol = inputs.tables.protocol;
  AnswersOfSession answers{};
  Course course(protocol, inputs.allocation, &inputs.tables.rules);
  for (std::size_t next = 0; next < course.plan().trials.size(); ++next) {
    const Trial& trial = course.plan().trials[next];
    const bool is_awaited = course.awaited() == &trial;
    const AnalysisUse use = answers.add_trial(trial);
    const bool is_read = use == AnalysisUse::counted || use == AnalysisUse::catch_trial;
    const QuestionTables* const tables = inputs.tables.questions_of(trial.block);
    ItemsByQuestion given{};
    if (tables != nullptr && (is_read || is_awaited)) given = responses_to(inputs, trial, *tables);
    if (is_read) {
      answers.begin_attempt(trial, use);
      for (const Question& question : trial.questions) {
        const auto items = given.find(question.name);
        if (items != given.end()) answers.add_replies(question, items->second);
      }
    }
    if (is_awaited) {
      course.advance(outcome_of_responses(protocol.blocks.at(trial.block), trial, given));
    }
  }
  return answers.take();
}

}  // namespace asperity
