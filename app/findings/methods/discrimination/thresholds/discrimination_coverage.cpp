// Compares the tracks of a block with a table of simulated procedures, written by scripts/recovery.

#include "app/findings/methods/discrimination/thresholds/discrimination_coverage.h"

#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "app/findings/outcome/display_number.h"

namespace asperity {

namespace {

constexpr double kLeastCoverage_percent = 93.0;
constexpr double kGreatestCoverage_percent = 97.0;

// numbers: written by scripts/recovery
constexpr std::array kSimulated{
    SimulatedCoverage{"3-down/1-up, 60 trials", 3, 0, 1, 60, 1.3, 91.0},
    SimulatedCoverage{"3-down/1-up, 2 × 40 trials", 3, 0, 2, 40, 1.3, 91.5},
    SimulatedCoverage{"2-down/1-up, 60 trials", 2, 0, 1, 60, 1.3, 89.8},
    SimulatedCoverage{"weighted up-down, 75 %, 60 trials", 1, 0.75, 1, 60, 1.3, 91.7},
    SimulatedCoverage{"3-down/1-up, 60 trials", 3, 0, 1, 60, 3.5, 97.5},
    SimulatedCoverage{"3-down/1-up, 2 × 40 trials", 3, 0, 2, 40, 3.5, 94.6},
    SimulatedCoverage{"2-down/1-up, 60 trials", 2, 0, 1, 60, 3.5, 97.4},
    SimulatedCoverage{"weighted up-down, 75 %, 60 trials", 1, 0.75, 1, 60, 3.5, 95.1}};
// end of numbers

bool is_of(const SimulatedCoverage& simulated, const std::vector<ProcedureSettings>& tracks) {
  if (tracks.size() != simulated.tracks) return false;
  return std::all_of(tracks.begin(), tracks.end(), [&](const ProcedureSettings& settings) {
    if (procedure_of(settings).most_trials(settings) != simulated.trials) return false;
    if (const auto* const weighted = std::get_if<WeightedUpDown>(&settings)) {
      return weighted->target == simulated.target && has_fixed_length(weighted->stop) &&
             !weighted->unforced_alternatives;
    }
    const auto* const transformed = std::get_if<TransformedUpDown>(&settings);
    return transformed != nullptr && simulated.target == 0.0 &&
           has_fixed_length(transformed->track.stop) &&
           transformed->track.rule == UpDownRule{.up = 1, .down = simulated.down} &&
           transformed->track.steps_up == transformed->track.steps_down;
  });
}

Phrase joined(const Phrase& one, const Phrase& other) {
  return one.empty() ? other : phrase("Analysis", "%1; %2").with(one, other);
}

/// "3-down/1-up, 2 × 40 trials"
Phrase words_of_design(const SimulatedCoverage& simulated) {
  const Phrase trials =
      simulated.tracks == 1
          ? phrase("Analysis", "%1 trials").with(std::to_string(simulated.trials))
          : phrase("Analysis", "%1 × %2 trials")
                .with(std::to_string(simulated.tracks), std::to_string(simulated.trials));
  return simulated.target > 0.0
             ? phrase("Analysis", "weighted up-down (%1 %), %2")
                   .with(display_number(100.0 * simulated.target), trials)
             : phrase("Analysis", "%1-down/1-up, %2").with(std::to_string(simulated.down), trials);
}

Phrase note_on_simulated(const std::vector<const SimulatedCoverage*>& rows) {
  Phrase all{};
  for (const SimulatedCoverage* const row : rows) {
    all = joined(all, phrase("Analysis", "%1 % of observers with slope β = %2")
                          .with(display_number(row->coverage_percent), display_number(row->beta)));
  }
  return phrase("Analysis",
                "In simulations of this procedure (%1), the 95 % CI of the threshold contained the "
                "true threshold for: %2.")
      .with(words_of_design(*rows.front()), all);
}

Phrase note_on_others() {
  const auto is_lower = [](const SimulatedCoverage& one, const SimulatedCoverage& other) {
    return one.coverage_percent < other.coverage_percent;
  };
  const auto [low, high] = std::minmax_element(kSimulated.begin(), kSimulated.end(), is_lower);
  return phrase("Analysis",
                "The coverage of the 95 % CIs was not simulated for the procedure of this study; "
                "it was %1 to %2 % for simulated procedures of 60 and 80 trials.")
      .with(display_number(low->coverage_percent), display_number(high->coverage_percent));
}

}  // namespace

Phrase note_on_unforced_jnd(bool is_performance) {
  if (is_performance) {
    return phrase("Analysis",
                  "In simulations of responses “cannot tell” (two alternatives, 36 to 144 trials "
                  "at five levels, 2000 tables per setting), the 95 % CI of the JND of a judgement "
                  "of performance contained the true JND in 88 to 96 % of the tables; with 36 "
                  "trials it is too narrow (88 to 91 %).");
  }
  return phrase("Analysis",
                "In simulations of responses “cannot tell” (36 to 144 trials at five levels, 2000 "
                "tables per setting), the 95 % CI of the JND of a comparison contained the true "
                "JND in 89 to 96 % of the tables that had one.");
}

std::span<const SimulatedCoverage> simulated_coverages() { return kSimulated; }

Phrase note_on_coverage(std::span<const BlockWithProcedure> blocks) {
  Phrase note{};
  std::vector<Phrase> stated{};
  const auto add = [&](const Phrase& sentence) {
    if (std::find(stated.begin(), stated.end(), sentence) != stated.end()) return;
    stated.push_back(sentence);
    note = note.empty() ? sentence : phrase("Analysis", "%1 %2").with(note, sentence);
  };
  for (const auto& [block, is_performance] : blocks) {
    std::vector<const SimulatedCoverage*> rows{};
    for (const SimulatedCoverage& simulated : kSimulated) {
      if (is_performance && block->procedure && is_of(simulated, block->procedure->tracks))
        rows.push_back(&simulated);
    }
    if (rows.empty()) {
      add(note_on_others());
      continue;
    }
    const bool is_as_stated =
        std::all_of(rows.begin(), rows.end(), [](const SimulatedCoverage* row) {
          return row->coverage_percent >= kLeastCoverage_percent &&
                 row->coverage_percent <= kGreatestCoverage_percent;
        });
    if (!is_as_stated) add(note_on_simulated(rows));
  }
  return note;
}

}  // namespace asperity
