// Lets virtual hands feel the extreme levels, and tests whether the observer's magnitude changes.

#include "app/tasks/warnings/observer_warnings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/session/attempt_measures.h"
#include "app/session/respondents/felt_surface.h"
#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/observer/virtual_observer.h"
#include "protocols/plan/plan.h"

namespace asperity {

namespace {

constexpr double kLeastChange = 0.02;  // of the natural logarithm
constexpr int kStrokes = 3;            // with other random numbers, as in other presentations

/// The presentations with the smallest and the largest value of the varied parameter, among which may be the standard, that
/// of its level nearest to the standard, and the standard.
struct Extremes {
  std::optional<double> least{};
  std::optional<double> greatest{};
  PlannedPresentation of_least{};
  PlannedPresentation of_greatest{};
  std::optional<PlannedPresentation> of_standard{};
  std::optional<double> distance{};  ///< of the nearest level
  PlannedPresentation of_nearest{};

  void add_level(double value, double standard, const PlannedPresentation& planned) {
    add(value, planned);
    if (distance && std::abs(value - standard) >= *distance) return;
    distance = std::abs(value - standard);
    of_nearest = planned;
  }
  void add(double value, const PlannedPresentation& planned) {
    if (!least || value < *least) {
      least = value;
      of_least = planned;
    }
    if (!greatest || value > *greatest) {
      greatest = value;
      of_greatest = planned;
    }
  }
};

/// Over the trials with the same levels of the other factors as the first one.
Extremes extremes_of(const std::vector<Trial>& trials, const Protocol::Block& block) {
  const Dimension& varied = *block.vary;
  Extremes found{};
  std::optional<std::map<std::string, Level, std::less<>>> others{};
  for (const Trial& trial : trials) {
    const auto level = trial.factors.find(varied.factor);
    if (trial.block != block.name || trial.catch_trial || trial.anchor ||
        level == trial.factors.end())
      continue;
    const auto* const value = std::get_if<double>(&level->second);
    if (value == nullptr) continue;
    auto own = trial.factors;
    own.erase(varied.factor);
    if (!others) others = own;
    if (own != *others) continue;
    for (const PlannedPresentation& planned : trial.presentations) {
      if (planned.role == varied.role) {
        found.add_level(*value, varied.standard.value_or(0.0), planned);
      }
      if (planned.role == varied.standard_role && varied.standard) {
        found.add(*varied.standard, planned);
        found.of_standard = planned;
      }
    }
  }
  return found;
}

/// The proportion of trials in which a threshold of this block must be distinguished from the standard.
double required_proportion(const Protocol::Block& block) {
  // The definition of the just-noticeable difference: halfway between guessing and certainty.
  const double at_threshold = 0.5 * (1.0 + block.design()->guess_rate());
  if (!block.procedure) return at_threshold;
  const ProcedureSettings& track = block.procedure->tracks.front();
  return std::max(at_threshold, procedure_of(track).target(track).value_or(at_threshold));
}

/// A magnitude from its natural logarithm, with three significant digits.
std::string magnitude_text(double log_magnitude) {
  const double magnitude = std::exp(log_magnitude);
  constexpr double kDigits = 3.0;
  const double decimals = std::max(0.0, kDigits - 1.0 - std::floor(std::log10(magnitude)));
  return fixed(magnitude, static_cast<int>(decimals));
}

std::string per_cent(double proportion) { return fixed(100.0 * proportion, 0); }

Phrase judged_force(ObserverDeclaration::MagnitudeOf what) {
  switch (what) {
    case ObserverDeclaration::MagnitudeOf::lateral_force:
      return phrase("Protocols", "the variation of the lateral force");
    case ObserverDeclaration::MagnitudeOf::normal_force:
      return phrase("Protocols", "the variation of the normal force");
    case ObserverDeclaration::MagnitudeOf::held_tool:
      return phrase("Protocols", "the vibration of a held tool");
    case ObserverDeclaration::MagnitudeOf::compliance:
      return phrase("Protocols", "the depth to which the surface yields over the normal force");
  }
  return {};
}

}  // namespace

std::vector<Diagnostic> warnings_about_observer(const CheckedProtocol& checked,
                                                StimulusBuilder& builder) {
  const Protocol& protocol = checked.protocol;
  std::vector<Diagnostic> warnings{};
  const ObserverDeclaration& observer = protocol.observer;
  const auto is_compared = [](const auto& named) {
    const Protocol::Block& block = named.second;
    return block.phase == Phase::main && block.vary && judged_question(block) != nullptr;
  };
  if (observer.deaf || std::none_of(protocol.blocks.begin(), protocol.blocks.end(), is_compared)) {
    return warnings;
  }
  const JsonDocument document(protocol.source, checked.file_name);
  const std::vector<Trial>& trials = checked.trials();
  for (const auto& named : protocol.blocks) {
    if (!is_compared(named)) continue;
    const Protocol::Block& block = named.second;
    const auto first = std::find_if(trials.begin(), trials.end(), [&block](const Trial& trial) {
      return trial.block == block.name;
    });
    const Extremes extremes = extremes_of(trials, block);
    if (first == trials.end() || !extremes.least || !extremes.of_standard ||
        *extremes.least == *extremes.greatest) {
      continue;
    }
    const auto magnitude_of = [&](const PlannedPresentation& planned) -> std::optional<double> {
      if (!builder.can_make(planned.stimulus)) return {};
      PreparedStimulus stimulus = builder.unmatched(planned.stimulus);
      stimulus.inputs.patch = planned.patch;
      const HandHabits habits = habits_for(exploration_of(protocol, *first), planned.patch);
      double sum = 0.0;
      for (int seed = 1; seed <= kStrokes; ++seed) {
        sum += judged_magnitude(felt_surface(*stimulus.model, stimulus.inputs, protocol, habits,
                                             Random(static_cast<std::uint64_t>(seed))),
                                observer.magnitude_of);
      }
      return sum / kStrokes;
    };
    const std::optional<double> least = magnitude_of(extremes.of_least);
    const std::optional<double> greatest = magnitude_of(extremes.of_greatest);
    const std::optional<double> standard = magnitude_of(*extremes.of_standard);
    if (!least || !greatest || !standard) continue;
    const double from_standard =
        std::max(std::abs(*least - *standard), std::abs(*greatest - *standard));
    const double distinguished = correct_proportion(observer, from_standard, *block.design());
    const double required = required_proportion(block);
    const double change = *greatest - *least;
    const std::string place = pointer_to("/blocks", block.name) + "/vary/parameter";
    const Phrase judged = judged_force(observer.magnitude_of);
    const Phrase magnitude_key = key_name("magnitude_of");
    const Phrase observer_key = key_name("observer");
    const std::string parameter = in_quotes(block.vary->parameter);
    const double from = std::min(*least, *standard);
    const double to = std::max(*greatest, *standard);
    if (block.design()->surfaces() == 1 && observer.discrimination.yes_above &&
        (std::log(*observer.discrimination.yes_above) <= from ||
         std::log(*observer.discrimination.yes_above) >= to)) {
      const double nearest = magnitude_of(extremes.of_nearest).value_or(*standard);
      const double farthest =
          std::abs(*least - *standard) > std::abs(*greatest - *standard) ? *least : *greatest;
      warnings.push_back(document.at(
          "/observer/yes_above",
          phrase("Protocols",
                 "the virtual observer judges %1, which is %2 at the standard and %3 to %4 at the "
                 "levels of %5: with this criterion nearly all simulated responses are the same. "
                 "State a value between that of the standard and those of the levels")
              .with(judged, magnitude_text(*standard), magnitude_text(nearest),
                    magnitude_text(farthest), parameter)));
    } else if (std::abs(change) < kLeastChange) {
      warnings.push_back(document.at(
          place,
          phrase("Protocols",
                 "the virtual observer judges %1, which does not change with %2: simulated "
                 "responses are guesses. State another %3 under %4, or a surface on which this "
                 "force depends on the parameter (its friction and its force_direction determine "
                 "the lateral force)")
              .with(judged, parameter, magnitude_key, observer_key)));
    } else if ((change < 0.0) != observer.discrimination.magnitude_decreases) {
      const Phrase sentence =
          change < 0.0
              ? phrase("Protocols",
                       "the virtual observer judges %1, which decreases by a factor of %2 where %3 "
                       "increases from its smallest to its largest value: simulated responses are "
                       "systematically incorrect. State %4: %5 under %6")
              : phrase("Protocols",
                       "the virtual observer judges %1, which increases by a factor of %2 where %3 "
                       "increases from its smallest to its largest value: simulated responses are "
                       "systematically incorrect. State %4: %5 under %6");
      warnings.push_back(document.at(
          place,
          sentence.with(judged, fixed(std::exp(std::abs(change)), 2), parameter, key_name("effect"),
                        in_quotes(change < 0.0 ? "decreases" : "increases"), observer_key)));
    } else if (distinguished < required) {
      const Phrase noise_key = key_name("feature_noise");
      const Phrase sentence =
          observer.lapse > 0.0
              ? phrase("Protocols",
                       "the virtual observer judges %1, which differs from the standard by a "
                       "factor of at most %2 within the levels of %3: with a %4 of %5 and a %8 of "
                       "%9 it distinguishes no level from the standard in more than %6 % of "
                       "trials, and a threshold requires %7 %")
              : phrase("Protocols",
                       "the virtual observer judges %1, which differs from the standard by a "
                       "factor of at most %2 within the levels of %3: with a %4 of %5 it "
                       "distinguishes no level from the standard in more than %6 % of trials, and "
                       "a threshold requires %7 %");
      const Phrase remedy =
          phrase("Protocols",
                 "State levels farther from the standard, or a smaller %1 or another %2 under %3")
              .with(noise_key, magnitude_key, observer_key);
      warnings.push_back(document.at(
          place,
          Phrase("%1. %2").with(
              sentence.with(judged, fixed(std::exp(from_standard), 2), parameter, noise_key,
                            number_text(observer.feature_noise), per_cent(distinguished),
                            per_cent(required), key_name("lapse"), number_text(observer.lapse)),
              remedy)));
    }
  }
  return warnings;
}

}  // namespace asperity
