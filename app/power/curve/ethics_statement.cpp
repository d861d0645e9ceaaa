// Composes sentences from the effect, the test, the curve and the rules of the sample.

#include "app/power/curve/ethics_statement.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"
#include "app/findings/outcome/study_test.h"
#include "app/power/curve/result_tables.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// "86.2 %"
std::string percent(double proportion) {
  return rounded_text(with_digits(100.0 * proportion, 3)) + " %";
}

/// ".05"
std::string without_zero(double probability) { return number_text(probability).substr(1); }

std::string with_unit(double value, const std::string& unit) {
  const bool is_pure = unit.empty() || unit == "1" || unit == "ratio";
  return rounded_text(value) + (is_pure ? "" : ' ' + unit);
}

std::string participants_text(std::size_t number) {
  return counted(number, "participant", "participants");
}

/// "assumed" of a value that the program proposes: no study and no person is its source.
std::string source_text(const Assumption& assumption) {
  return assumption.source == kAssumed ? "usual value of Asperity, assumed and not measured"
                                       : assumption.source;
}

std::vector<const Assumption*> effects_to_detect(const PlannedStudy& study) {
  std::vector<const Assumption*> effects{};
  for (const Assumption& one : study.assumptions) {
    if (one.part != Assumption::Part::effect || !one.value) continue;
    if (*one.value != one.null_value) effects.push_back(&one);
  }
  std::vector<const Assumption*> stated{};
  std::copy_if(
      effects.begin(), effects.end(), std::back_inserter(stated), [&study](const Assumption* one) {
        return std::find(study.stated_effects.begin(), study.stated_effects.end(), one->name) !=
               study.stated_effects.end();
      });
  return stated.empty() ? effects : stated;
}

/// Whether it concerns a curve: "order" is the name in "order rough|smooth", and it is among "order, side".
bool concerns(const Assumption& effect, const std::string& test) {
  const std::string name = test.substr(0, test.find(' '));
  for (std::string part : parts_of(effect.tests, ',')) {
    part.erase(0, part.find_first_not_of(' '));
    if (part == name) return true;
  }
  return false;
}

/// Whether a test needs more participants than another one.
bool needs_more(const PowerCurve& one, const PowerCurve& other, double power,
                const SampleRules& rules) {
  const auto needed = [&](const PowerCurve& curve) {
    return planned_sample(curve, power, rules).participants;
  };
  const auto first = needed(one);
  const auto second = needed(other);
  if (first && second && *first != *second) return *first > *second;
  if (first.has_value() != second.has_value()) return !first;
  return one.sizes.back().power.fitted < other.sizes.back().power.fitted;
}

/// Nothing where no curve concerns the effect; a null effect is concerned by all.
std::optional<PlannedEffect> planned_effect(const PlannedStudy& study, const Assumption* effect,
                                            double power) {
  PlannedEffect planned{.effect = effect};
  for (const PowerCurve& curve : study.curves) {
    if (curve.test.empty()) continue;
    if (effect != nullptr && !concerns(*effect, curve.test)) continue;
    ++planned.tests;
    if (planned.curve == nullptr || needs_more(curve, *planned.curve, power, study.rules)) {
      planned.curve = &curve;
    }
  }
  return planned.curve == nullptr ? std::nullopt : std::optional(planned);
}

std::string interval_text(const ConfidenceInterval& interval) {
  return "95 % Monte-Carlo CI [" + percent(interval.low) + ", " + percent(interval.high) + "]";
}

/// "pairs.order = 0.5 d′ (advantage of the first surface; without an effect 0 d′; source: stated by the researcher)"
std::string effect_text(const PlannedEffect& planned) {
  if (planned.effect == nullptr) {
    return "the effect that the stimuli of the protocol have on its virtual observers, who feel "
           "them on the full physics";
  }
  const Assumption& effect = *planned.effect;
  return effect.name + " = " + with_unit(*effect.value, effect.unit) + " (" +
         effect.meaning.english() + "; without an effect " +
         with_unit(effect.null_value, effect.unit) + "; source: " + source_text(effect) + ')';
}

std::string correction_text(const PlannedStudy& study, const PowerCurve& curve) {
  const auto tests =
      std::count_if(study.curves.begin(), study.curves.end(), [&curve](const PowerCurve& other) {
        return other.family == curve.family && !other.test.empty();
      });
  return tests > 1 ? "Holm-corrected over the " + std::to_string(tests) +
                         " tests of the family \"" + curve.family + '"'
                   : "uncorrected, because it is the only test of its family";
}

/// "Statistical test: paired t test, two-sided ("order"), at α = .05, …".
std::string test_text(const PlannedStudy& study, const PlannedEffect& planned) {
  const PowerCurve& curve = *planned.curve;
  const std::string methods = methods_text(curve);
  std::string text = "Statistical test: " + methods + (methods.empty() ? "\"" : " (\"") +
                     curve.test + (methods.empty() ? "\"" : "\")") +
                     ", at α = " + without_zero(StudyTest::kLevel) + ", " +
                     correction_text(study, curve);
  if (planned.tests > 1) {
    text += "; of the " + std::to_string(planned.tests) + " tests " +
            (planned.effect != nullptr ? "that concern this effect" : "of the analysis") +
            ", it needs the most participants";
  }
  return text + ". ";
}

/// "interpolated between the simulated numbers 20 and 30"
std::string place_text(const PowerEstimate& estimate, std::size_t participants) {
  if (estimate.below != estimate.above) {
    return ", interpolated between the simulated numbers " + std::to_string(estimate.below) +
           " and " + std::to_string(estimate.above);
  }
  if (static_cast<std::size_t>(estimate.above) == participants) return {};
  return ", simulated with " + participants_text(static_cast<std::size_t>(estimate.above));
}

/// ", where the analysis gave no p in 3 of 1000 studies, …": of the simulated number that is next to it from above.
std::string without_p_text(const PowerCurve& curve, std::size_t participants) {
  const auto found = std::find_if(curve.sizes.begin(), curve.sizes.end(), [&](const auto& size) {
    return static_cast<std::size_t>(size.power.participants) >= participants;
  });
  const TestAtSize& size = found == curve.sizes.end() ? curve.sizes.back() : *found;
  if (size.without_p == 0) return {};
  return " In " + std::to_string(size.without_p) + " of the " + std::to_string(size.studies) +
         " simulated studies with " +
         participants_text(static_cast<std::size_t>(size.power.participants)) +
         ", the analysis gave no p for this test; they count as not significant.";
}

std::string estimate_text(const PowerCurve& curve, std::size_t participants) {
  const PowerEstimate estimate = power_at(curve, participants);
  return "with " + participants_text(participants) + ", the power is estimated at " +
         percent(estimate.power) + " (" + interval_text(estimate.interval) +
         place_text(estimate, participants) + ")." + without_p_text(curve, participants);
}

/// "25 (95 % Monte-Carlo CI [24, 27])": what lies outside the simulated numbers is named.
std::string smallest_text(const PlannedSample& sample, const PowerCurve& curve) {
  const auto end = [&curve](const std::optional<std::size_t>& limit, bool is_low) {
    if (limit) return std::to_string(*limit);
    const TestAtSize& size = is_low ? curve.sizes.front() : curve.sizes.back();
    return std::string(is_low ? "at most " : "above ") + std::to_string(size.power.participants);
  };
  const bool may_be_smaller = sample.reached == PowerReached::at_first;
  return (may_be_smaller ? "at most " : "") + std::to_string(*sample.participants) +
         (may_be_smaller ? ", the smallest simulated number" : "") + " (95 % Monte-Carlo CI [" +
         end(sample.low, true) + ", " + end(sample.high, false) + "])";
}

/// The effect with its test, its smallest number and the estimated power with the planned number; nothing planned: with the largest
/// simulated one, if the effect does not reach the power.
std::string paragraph_of(const PlannedStudy& study, const PlannedEffect& planned, double power,
                         const std::optional<std::size_t>& participants) {
  const PowerCurve& curve = *planned.curve;
  const PlannedSample sample = planned_sample(curve, power, study.rules);
  std::string text =
      "Effect to be detected: " + effect_text(planned) + ". " + test_text(study, planned);
  const auto largest = static_cast<std::size_t>(curve.sizes.back().power.participants);
  if (!sample.participants) {
    return text + "No simulated number of participants has an estimated power of " +
           percent(power) + ": " + estimate_text(curve, largest);
  }
  text += "The smallest number of participants with an estimated power of " + percent(power) +
          " is " + smallest_text(sample, curve);
  return participants ? text + "; " + estimate_text(curve, *participants) : text + '.';
}

/// "one; two": of parts that contain commas.
std::string joined(const std::vector<std::string>& parts) {
  std::string text{};
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

std::string deviations_text(const PlannedStudy& study) {
  if (study.is_on_physics) {
    return "All virtual observers are alike: no effect differs between them, as effects on human "
           "participants do, so that the power with human participants is lower.";
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> names_by_text{};
  std::size_t others = 0;
  for (const Assumption& one : study.assumptions) {
    if (one.part == Assumption::Part::other) ++others;
    if (one.part != Assumption::Part::effect_sd || !one.value) continue;
    const std::string text = " = " + with_unit(*one.value, one.unit) + " (" +
                             one.meaning.english() + "; source: " + source_text(one) + ')';
    auto same = std::find_if(names_by_text.begin(), names_by_text.end(),
                             [&text](const auto& each) { return each.first == text; });
    if (same == names_by_text.end()) same = names_by_text.insert(same, {text, {}});
    same->second.push_back(one.name);
  }
  std::vector<std::string> texts{};
  for (const auto& [text, names] : names_by_text) {
    texts.push_back(listed(names) + (names.size() > 1 ? ", each" : "") + text);
  }
  std::string text =
      texts.empty()
          ? std::string("No effect differs between participants.")
          : "Standard deviations of the effects over participants: " + joined(texts) + '.';
  if (others == 0) return text;
  return text + " The simulation has " +
         counted(others, "further assumption, which is", "further assumptions, which are") +
         " listed with " + (others == 1 ? "its source" : "their sources") +
         " in the table of assumptions.";
}

std::string recruited_text(const PlannedSample& sample, const Attrition& attrition) {
  if (attrition.dropout == 0.0 && attrition.exclusion == 0.0) {
    return "No dropout and no exclusion of participants are assumed (rates of 0 %): " +
           participants_text(*sample.planned) + " are recruited.";
  }
  return "With a dropout rate of " + percent(attrition.dropout) + " and an exclusion rate of " +
         percent(attrition.exclusion) + ", " + participants_text(sample.recruited->assured) +
         " are recruited, of whom at least " + std::to_string(*sample.planned) +
         " can be analysed with a probability of at least " + percent(kAssurance) + " (with " +
         std::to_string(sample.recruited->on_average) +
         " recruited, this number is reached on "
         "average).";
}

std::string simulation_text(const PlannedStudy& study) {
  return "The power was estimated with " +
         counted(static_cast<std::size_t>(study.runs), "simulated study", "simulated studies") +
         " for each number of participants (" + study.program + ", protocol " + study.protocol +
         ", with its plan, procedures, exclusion rules and analysis).";
}

/// The first sentences: the number, and what it follows from.
std::string sample_text(const PlannedStudy& study, const std::vector<PlannedEffect>& effects,
                        const PlannedEffect& deciding, const PlannedSample& sample) {
  if (!sample.planned) {
    return "Sample size: not determined, because no simulated number of participants has an "
           "estimated power of " +
           percent(sample.power) + (effects.size() > 1 ? " for every effect. " : ". ") +
           simulation_text(study);
  }
  std::string text = "Sample size: " + participants_text(*sample.planned) +
                     " with data to be analysed, for an estimated power of at least " +
                     percent(sample.power) + (effects.size() > 1 ? " for each effect. " : ". ") +
                     simulation_text(study);
  if (study.rules.multiple > 1) {
    text += " The sample size is a multiple of " + std::to_string(study.rules.multiple) +
            ", the number of participants in one round of counterbalancing and groups.";
  }
  if (effects.size() > 1) {
    text += " The effect " + deciding.effect->name +
            " determines the sample size, because it needs the most participants.";
  }
  return text;
}

}  // namespace

bool is_from_pilot(const Assumption& assumption) {
  constexpr const char* kPilot = "pilot";
  return assumption.part == Assumption::Part::effect && assumption.source.rfind(kPilot, 0) == 0;
}

std::vector<PlannedEffect> planned_effects(const PlannedStudy& study, double power) {
  std::vector<const Assumption*> effects = effects_to_detect(study);
  if (study.is_on_physics) effects = {nullptr};
  std::vector<PlannedEffect> all{};
  for (const Assumption* const effect : effects) {
    if (const auto planned = planned_effect(study, effect, power)) all.push_back(*planned);
  }
  return all;
}

const PlannedEffect* deciding_effect(const std::vector<PlannedEffect>& effects, double power,
                                     const SampleRules& rules) {
  const auto most =
      std::max_element(effects.begin(), effects.end(), [&](const auto& one, const auto& other) {
        return needs_more(*other.curve, *one.curve, power, rules);
      });
  return most == effects.end() ? nullptr : &*most;
}

std::string ethics_statement(const PlannedStudy& study, double power) {
  const std::vector<PlannedEffect> effects = planned_effects(study, power);
  const PlannedEffect* const deciding = deciding_effect(effects, power, study.rules);
  if (deciding == nullptr) return {};
  const PlannedSample sample = planned_sample(*deciding->curve, power, study.rules);
  std::string text = sample_text(study, effects, *deciding, sample);
  for (const PlannedEffect& effect : effects) {
    text += '\n' + paragraph_of(study, effect, power, sample.planned);
  }
  text += '\n' + deviations_text(study);
  if (sample.planned) text += '\n' + recruited_text(sample, study.rules.attrition);
  return text;
}

}  // namespace asperity
