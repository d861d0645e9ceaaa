// The one list of the procedures; a new one adds its include in procedure.h, its alternative there, and its line here.

#include <algorithm>
#include <array>
#include <stdexcept>

#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

void refuse_problems(const ProcedureSettings& settings) {
  const std::vector<ProcedureProblem> problems = problems_of(settings);
  if (problems.empty()) return;
  throw std::invalid_argument(problems.front().setting + ": " + problems.front().message.english());
}

}  // namespace

std::span<const Procedure* const> procedures() {
  static const std::array kProcedures{&constant_stimuli(), &transformed_up_down(),
                                      &weighted_up_down(), &psi(),
                                      &quest_plus(),       &external()};
  static_assert(kProcedures.size() == std::variant_size_v<ProcedureSettings>);
  return kProcedures;
}

const Procedure* find_procedure(std::string_view id) noexcept {
  const auto all = procedures();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [id](const Procedure* procedure) { return procedure->id == id; });
  return found == all.end() ? nullptr : *found;
}

const Procedure& procedure_of(const ProcedureSettings& settings) {
  return *procedures()[settings.index()];
}

const PosteriorTrack* posterior_track_of(const ProcedureSettings& settings) noexcept {
  if (const auto* const psi = std::get_if<Psi>(&settings)) return &psi->track;
  if (const auto* const quest = std::get_if<QuestPlus>(&settings)) return &quest->track;
  return nullptr;
}

std::vector<ProcedureProblem> problems_of(const ProcedureSettings& settings) {
  ProcedureProblems problems{};
  procedure_of(settings).check(settings, problems);
  return problems.all();
}

LevelRule level_rule(const ProcedureSettings& settings) {
  refuse_problems(settings);
  return procedure_of(settings).rule(settings);
}

NextStep next_step(const ProcedureSettings& settings, std::span<const LevelAnswer> answers,
                   const Random& of_track) {
  return level_rule(settings)(answers, of_track);
}

std::vector<LevelAnswer> simulated_track(const LevelRule& rule, const OutcomeOfObserver& observer,
                                         const Random& of_track) {
  Random responses = of_track.split("responses");
  std::vector<LevelAnswer> answers{};
  for (;;) {
    const NextStep step = rule(answers, of_track);
    const NextLevel* const next = std::get_if<NextLevel>(&step);
    if (next == nullptr) return answers;
    answers.push_back({.level = next->level, .outcome = observer(next->level, responses)});
  }
}

std::vector<LevelAnswer> simulated_track(const LevelRule& rule, const ChanceOfCorrect& observer,
                                         const Random& of_track) {
  return simulated_track(rule, OutcomeOfObserver([&observer](double level, Random& responses) {
                           return forced_outcome(responses.uniform() < observer(level));
                         }),
                         of_track);
}

std::vector<LevelAnswer> simulated_track(const ProcedureSettings& settings,
                                         const ChanceOfCorrect& observer, const Random& of_track) {
  return simulated_track(level_rule(settings), observer, of_track);
}

double expected_trials(const ProcedureSettings& settings, const ChanceOfCorrect& observer) {
  refuse_problems(settings);
  const Procedure& procedure = procedure_of(settings);
  if (procedure.has_fixed_length(settings)) {
    return static_cast<double>(procedure.most_trials(settings));
  }
  const LevelRule rule = procedure.rule(settings);
  const Random seeded = Random(1).split("expected_trials");
  std::size_t trials = 0;
  for (std::size_t track = 0; track < procedure.simulated_tracks; ++track) {
    trials +=
        simulated_track(rule, observer, seeded.split(static_cast<std::uint64_t>(track))).size();
  }
  return static_cast<double>(trials) / static_cast<double>(procedure.simulated_tracks);
}

}  // namespace asperity
