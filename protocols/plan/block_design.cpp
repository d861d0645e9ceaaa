// Implements the design of a discrimination block in one sentence.

#include "protocols/plan/block_design.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/psychometric/psychometric_function.h"
#include "protocols/design/block_factors.h"
#include "protocols/design/wording.h"
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

/// "TEXT, NEXT"
Phrase followed(const Phrase& text, const Phrase& next) {
  return phrase("Lists", "%1, %2").with(text, next);
}

Phrase trials_text(std::size_t trials) {
  return trials == 1 ? phrase("Protocols", "1 trial")
                     : phrase("Protocols", "%1 trials").with(std::to_string(trials));
}

Phrase method_text(const ProcedureSettings& settings) {
  if (const auto* const transformed = std::get_if<TransformedUpDown>(&settings)) {
    const UpDownRule& rule = transformed->track.rule;
    return phrase("Protocols", "%1-down/%2-up staircase")
        .with(std::to_string(rule.down), std::to_string(rule.up));
  }
  if (std::holds_alternative<WeightedUpDown>(settings)) {
    return phrase("Protocols", "weighted up-down staircase");
  }
  if (posterior_track_of(settings) != nullptr) {
    return procedure_of(settings).id == psi().id ? phrase("Protocols", "psi procedure") : "QUEST+";
  }
  if (std::holds_alternative<External>(settings)) {
    return phrase("Protocols", "levels of an external program (unknown before the session)");
  }
  return phrase("Protocols", "constant stimuli");
}

/// "constant stimuli, 5 levels × 16 presentations"
Phrase constant_text(const Block& block) {
  const std::size_t levels = block.vary->levels().size();
  const std::size_t each =
      static_cast<std::size_t>(block.repetitions) * block.design()->trials.size();
  Phrase text = followed(
      phrase("Protocols", "constant stimuli"),
      phrase("Protocols", "%1 × %2")
          .with(levels == 1 ? phrase("Protocols", "1 level")
                            : phrase("Protocols", "%1 levels").with(std::to_string(levels)),
                each == 1 ? phrase("Protocols", "1 presentation")
                          : phrase("Protocols", "%1 presentations").with(std::to_string(each))));
  if (!block.design()->has_noise()) return text;
  return followed(text, phrase("Protocols", "half of them without a difference"));
}

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

Phrase presentation_text(const Block& block) {
  const Arrangement& arrangement = block.arrangement;
  const bool is_sequential = arrangement.surfaces == Arrangement::Surfaces::sequential;
  const Phrase task = block.design() == &two_alternatives() && is_sequential
                          ? phrase("Protocols", "two-interval forced choice")
                          : phrase_of_key(block.design()->name);
  switch (arrangement.surfaces) {
    case Arrangement::Surfaces::sequential: {
      const Phrase text = followed(task, block.design()->surfaces() == 1
                                             ? phrase("Protocols", "one surface in each trial")
                                             : phrase("Protocols", "one surface after the other"));
      if (arrangement.minimum_visits == 1) return text;
      return followed(text, phrase("Protocols", "each presented %1 times")
                                .with(std::to_string(arrangement.minimum_visits)));
    }
    case Arrangement::Surfaces::side_by_side:
      return followed(task, phrase("Protocols", "side by side"));
    case Arrangement::Surfaces::on_request:
      return followed(task, phrase("Protocols", "surfaces felt on request"));
  }
  return {};
}

Phrase procedure_text(const Protocol::Block& block) {
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  const ProcedureSettings& first = tracks.front();
  const Procedure& procedure = procedure_of(first);
  Phrase text = method_text(first);
  if (const auto target = procedure.target(first)) {
    text = phrase("Protocols", "%1 (%2 %)").with(text, fixed(100.0 * *target, 1));
  }
  Phrase length = trials_text(procedure.most_trials(first));
  if (!procedure.has_fixed_length(first)) {
    length = phrase("Protocols", "at most %1").with(length);
  }
  if (tracks.size() > 1) {
    length =
        (block.order == Block::Order::fixed ? phrase("Protocols", "%1 × %2 tracks")
                                            : phrase("Protocols", "%1 × %2 interleaved tracks"))
            .with(length, std::to_string(tracks.size()));
  }
  text = followed(text, length);
  const auto& catch_trials = block.procedure->catch_trials;
  if (!catch_trials) return text;
  return followed(text, phrase("Protocols", "one catch trial in every %1 trials")
                            .with(std::to_string(catch_trials->every)));
}

Phrase design_of(const Protocol& protocol, const Block& block, const Plan& plan) {
  if (block.kind != discrimination_kind().id || !block.vary) return {};
  Phrase text = followed(presentation_text(block),
                         block.procedure ? procedure_text(block) : constant_text(block));
  Block alone = block;
  alone.vary.reset();
  alone.procedure.reset();
  alone.own = DiscriminationBlock{};
  if (const std::size_t rows = row_count(protocol, alone); rows > 1) {
    text =
        followed(text, phrase("Protocols", "for each of %1 conditions").with(std::to_string(rows)));
  }
  double time_s = 0.0;
  for (const PlanStep& step : plan.steps) {
    const auto* const of_trial = std::get_if<TrialStep>(&step);
    if (of_trial == nullptr || plan.trials[of_trial->trial].block != block.name) continue;
    time_s += cost_of(protocol, plan, step).total_s;
  }
  text = followed(text, phrase("Protocols", "about %1 min").with(fixed(time_s / 60.0, 0)));
  if (const auto error = least_threshold_error(block)) {
    text = phrase("Protocols", "%1; standard error of the log10 threshold at least %2 (β = %3)")
               .with(text, fixed(*error, 2), number_text(kIncrementSlope));
  }
  return text;
}

}  // namespace asperity
