// Implements the design of a discrimination block in one sentence.

#include "protocols/plan/block_design.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/psychometric/psychometric_function.h"
#include "protocols/design/block_factors.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

PsychometricFunction assumed_function(const Block& block) {
  const Dimension& dimension = *block.vary;
  const std::vector<double> values = dimension.values();
  const double smallest = values.front() - *dimension.standard;
  const double largest = values.back() - *dimension.standard;
  return {.shape = PsychometricShape::weibull,
          .alpha = std::sqrt(smallest * largest),
          .beta = kIncrementSlope,
          .gamma = block.design()->guess_rate(),
          .lambda = 0.02};
}

double information_at(const PsychometricFunction& f, double increment) {
  const double psi = f.value(increment);
  const double slope = std::numbers::ln10 * f.beta * (1.0 - f.gamma - f.lambda) *
                       standard_curve(f.shape, standard_argument(f, increment)).d1;
  return slope * slope / (psi * (1.0 - psi));
}

/// The sum over the tracks of one combination, averaged over simulated sets of tracks.
double information_of_tracks(const Block& block, const PsychometricFunction& f) {
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  // A simulated track of n trials takes n²/2 steps.
  const Procedure& procedure = procedure_of(tracks.front());
  const std::size_t trials = procedure.most_trials(tracks.front());
  const std::uint64_t sets = std::min<std::uint64_t>(
      std::clamp<std::uint64_t>(20'000 / std::max<std::size_t>(trials, 1), 5, 200),
      procedure.simulated_tracks);
  std::vector<LevelRule> rules{};
  for (const ProcedureSettings& settings : tracks) rules.push_back(level_rule(settings));
  const Dimension& dimension = *block.vary;
  const auto increment_of = [&dimension](double level) {
    return dimension.value_of(level) - *dimension.standard;
  };
  const auto chance = [&](double level) { return f.value(increment_of(level)); };
  const Random seeded = Random(1).split("least_threshold_error");
  double sum = 0.0;
  for (std::uint64_t set = 0; set < sets; ++set) {
    std::uint64_t track = 0;
    for (const LevelRule& rule : rules) {
      const Random of_track = seeded.split(set).split(track++);
      for (const LevelAnswer& answer : simulated_track(rule, chance, of_track)) {
        sum += information_at(f, increment_of(answer.level));
      }
    }
  }
  return sum / static_cast<double>(sets);
}

std::string per_cent(double proportion) { return fixed(100.0 * proportion, 1) + " %"; }

}  // namespace

std::optional<double> least_threshold_error(const Block& block) {
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (!block.vary || !block.vary->standard || judged == nullptr || block.design()->has_noise() ||
      judged->judgement() != DiscriminationJudgement::performance) {
    return {};
  }
  // Where the trials will be is unknown.
  if (block.procedure && std::holds_alternative<External>(block.procedure->tracks.front())) {
    return {};
  }
  const std::vector<double> values = block.vary->values();
  if (values.empty() || values.front() <= *block.vary->standard) return {};
  const PsychometricFunction f = assumed_function(block);
  double information = 0.0;
  if (block.procedure) {
    information = information_of_tracks(block, f);
  } else {
    for (const double value : values) {
      information += information_at(f, value - *block.vary->standard);
    }
    information *=
        static_cast<double>(block.repetitions) * static_cast<double>(block.design()->trials.size());
  }
  return 1.0 / std::sqrt(information);
}

std::string presentation_text(const Block& block) {
  const Arrangement& arrangement = block.arrangement;
  const bool is_sequential = arrangement.surfaces == Arrangement::Surfaces::sequential;
  const std::string task = block.design() == &two_alternatives() && is_sequential
                               ? "two-interval forced choice"
                               : std::string(block.design()->name);
  switch (arrangement.surfaces) {
    case Arrangement::Surfaces::sequential:
      return task +
             (block.design()->surfaces() == 1 ? ", one surface in each trial"
                                              : ", one surface after the other") +
             (arrangement.minimum_visits == 1
                  ? std::string()
                  : ", each presented " + std::to_string(arrangement.minimum_visits) + " times");
    case Arrangement::Surfaces::side_by_side:
      return task + ", side by side";
    case Arrangement::Surfaces::on_request:
      return task + ", surfaces felt on request";
  }
  return {};
}

std::string procedure_text(const Protocol::Block& block) {
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  const ProcedureSettings& first = tracks.front();
  const Procedure& procedure = procedure_of(first);
  std::string text = "constant stimuli";
  if (const auto* const transformed = std::get_if<TransformedUpDown>(&first)) {
    text = std::to_string(transformed->track.rule.down) + "-down/" +
           std::to_string(transformed->track.rule.up) + "-up staircase";
  } else if (std::holds_alternative<WeightedUpDown>(first)) {
    text = "weighted up-down staircase";
  } else if (posterior_track_of(first) != nullptr) {
    text = procedure.id == psi().id ? "psi procedure" : "QUEST+";
  } else if (std::holds_alternative<External>(first)) {
    text = "levels of an external program (unknown before the session)";
  }
  if (const auto target = procedure.target(first)) text += " (" + per_cent(*target) + ")";
  text += procedure.has_fixed_length(first) ? ", " : ", at most ";
  text += counted(procedure.most_trials(first), "trial", "trials");
  if (tracks.size() > 1) {
    text += " × " + std::to_string(tracks.size());
    text += block.order == Block::Order::fixed ? " tracks" : " interleaved tracks";
  }
  if (const auto& catch_trials = block.procedure->catch_trials) {
    text += ", one catch trial in every " + std::to_string(catch_trials->every) + " trials";
  }
  return text;
}

std::string design_of(const Protocol& protocol, const Block& block, const Plan& plan) {
  if (block.kind != discrimination_kind().id || !block.vary) return {};
  std::string text = presentation_text(block) + ", ";
  if (block.procedure) {
    text += procedure_text(block);
  } else {
    text += "constant stimuli, " + counted(block.vary->levels().size(), "level", "levels") + " × " +
            counted(static_cast<std::size_t>(block.repetitions) * block.design()->trials.size(),
                    "presentation", "presentations") +
            (block.design()->has_noise() ? ", half of them without a difference" : "");
  }
  Block alone = block;
  alone.vary.reset();
  alone.procedure.reset();
  alone.own = DiscriminationBlock{};
  if (const std::size_t rows = row_count(protocol, alone); rows > 1) {
    text += ", for each of " + std::to_string(rows) + " conditions";
  }
  double time_s = 0.0;
  for (const PlanStep& step : plan.steps) {
    const auto* const of_trial = std::get_if<TrialStep>(&step);
    if (of_trial == nullptr || plan.trials[of_trial->trial].block != block.name) continue;
    time_s += cost_of(protocol, plan, step).total_s;
  }
  text += ", about " + fixed(time_s / 60.0, 0) + " min";
  if (const auto error = least_threshold_error(block)) {
    text += "; standard error of the log10 threshold at least " + fixed(*error, 2) +
            " (β = " + number_text(kIncrementSlope) + ")";
  }
  return text;
}

}  // namespace asperity
