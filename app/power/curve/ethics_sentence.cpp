#include "app/power/curve/ethics_sentence.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/number_text.h"
#include "app/findings/study/study_test.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

std::string percent(double proportion) {
  return number_text(std::round(1000.0 * proportion) / 10.0) + " %";
}

/// ".05"
std::string without_zero(double probability) { return number_text(probability).substr(1); }

std::string with_unit(double value, const std::string& unit) {
  return number_text(value) + (unit.empty() || unit == "1" ? "" : ' ' + unit);
}

/// The effects to be detected: those that were stated, or otherwise all; without those whose value is that without an effect.
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

/// "order": the name in "order rough|smooth", and whether it is among "order, side".
bool concerns(const Assumption& effect, const std::string& test) {
  const std::string name = test.substr(0, test.find(' '));
  for (std::string part : parts_of(effect.tests, ',')) {
    part.erase(0, part.find_first_not_of(' '));
    if (part == name) return true;
  }
  return false;
}

struct ConcernedTests {
  std::vector<const PowerCurve*> curves{};
  bool are_of_effect = false;  ///< false: all tests, because the effects concern none
};

ConcernedTests concerned_tests(const PlannedStudy& study) {
  const std::vector<const Assumption*> effects = effects_to_detect(study);
  ConcernedTests concerned{.are_of_effect = true};
  std::vector<const PowerCurve*> all{};
  for (const PowerCurve& curve : study.curves) {
    if (curve.test.empty()) continue;
    all.push_back(&curve);
    const bool is_concerned =
        std::any_of(effects.begin(), effects.end(),
                    [&curve](const Assumption* effect) { return concerns(*effect, curve.test); });
    if (is_concerned) concerned.curves.push_back(&curve);
  }
  if (concerned.curves.empty()) return {.curves = std::move(all)};
  return concerned;
}

/// Whether a test needs more participants than another one.
bool needs_more(const PowerCurve& one, const PowerCurve& other, double power,
                const SampleRules& rules) {
  const auto needed = [&](const PowerCurve& curve) {
    return planned_sample(curve, power, rules).smallest.participants;
  };
  const auto first = needed(one);
  const auto second = needed(other);
  if (first && second) return *first > *second;
  if (first || second) return !first;
  return one.sizes.back().power.fitted < other.sizes.back().power.fitted;
}

std::string effects_text(const PlannedStudy& study) {
  if (study.is_on_physics) {
    return "the effect that the stimuli of the protocol have on its virtual observers, who feel "
           "them on the full physics,";
  }
  std::vector<std::string> texts{};
  for (const Assumption* effect : effects_to_detect(study)) {
    texts.push_back(effect->name + " = " + with_unit(*effect->value, effect->unit) + " (" +
                    effect->meaning + "; " + number_text(effect->null_value) +
                    " without an effect; source: " + effect->source + ')');
  }
  return listed(texts);
}

std::string correction_text(const PlannedStudy& study, const PowerCurve& deciding) {
  const auto tests =
      std::count_if(study.curves.begin(), study.curves.end(), [&deciding](const PowerCurve& curve) {
        return curve.family == deciding.family && !curve.test.empty();
      });
  return tests > 1 ? "Holm-corrected over the " + std::to_string(tests) + " tests of the family " +
                         deciding.family
                   : "uncorrected, as the only test of its family";
}

std::string deviations_text(const PlannedStudy& study) {
  if (study.is_on_physics) {
    return "all observers are those of the protocol: no effect differs between participants, as "
           "effects on human participants do";
  }
  std::vector<std::string> texts{};
  std::size_t others = 0;
  for (const Assumption& one : study.assumptions) {
    if (one.part == Assumption::Part::effect_sd && one.value) {
      texts.push_back(one.name + " = " + with_unit(*one.value, one.unit) +
                      " (source: " + one.source + ')');
    } else if (one.part == Assumption::Part::other) {
      ++others;
    }
  }
  std::string text = texts.empty() ? std::string("no effect differs between participants")
                                   : "standard deviations of the effects: " + listed(texts);
  if (others > 0) {
    text += "; further assumptions: " + std::to_string(others) +
            ", listed with their sources in "
            "the table of assumptions";
  }
  return text;
}

/// "22.3, 95 % Monte-Carlo CI [21.0, 23.9]": what lies outside the simulated numbers is named.
std::string smallest_text(const SmallestSample& smallest, const PowerCurve& curve) {
  const auto end = [&curve](const std::optional<double>& limit, bool is_low) {
    if (limit) return fixed(*limit, 1);
    const TestAtSize& size = is_low ? curve.sizes.front() : curve.sizes.back();
    return std::string(is_low ? "at most " : "above ") + std::to_string(size.power.participants);
  };
  const bool may_be_smaller = smallest.reached == PowerReached::at_first;
  return (may_be_smaller ? "at most " : "") + fixed(*smallest.participants, 1) +
         ", 95 % Monte-Carlo CI [" + end(smallest.low, true) + ", " + end(smallest.high, false) +
         ']';
}

std::string recruited_text(const PlannedSample& sample, const Attrition& attrition) {
  if (attrition.dropout == 0.0 && attrition.exclusion == 0.0) return {};
  return "; with a dropout of " + percent(attrition.dropout) + " and an exclusion of " +
         percent(attrition.exclusion) + " of the participants, " +
         std::to_string(sample.recruited->on_average) +
         " are recruited so that this number is reached on average, or " +
         std::to_string(sample.recruited->assured) +
         " so that it is reached with a probability of " + percent(kAssurance);
}

}  // namespace

bool is_from_pilot(const Assumption& assumption) {
  constexpr const char* kPilot = "pilot";
  return assumption.part == Assumption::Part::effect && assumption.source.rfind(kPilot, 0) == 0;
}

const PowerCurve* deciding_curve(const PlannedStudy& study, double power) {
  const ConcernedTests concerned = concerned_tests(study);
  const auto most = std::max_element(concerned.curves.begin(), concerned.curves.end(),
                                     [&](const PowerCurve* one, const PowerCurve* other) {
                                       return needs_more(*other, *one, power, study.rules);
                                     });
  return most == concerned.curves.end() ? nullptr : *most;
}

std::string ethics_sentence(const PlannedStudy& study, double power) {
  const PowerCurve* const deciding = deciding_curve(study, power);
  if (deciding == nullptr) return {};
  const PlannedSample sample = planned_sample(*deciding, power, study.rules);
  const TestAtSize& largest = deciding->sizes.back();
  const ConcernedTests concerned = concerned_tests(study);
  std::string test = "the test " + deciding->test + " at α = " + without_zero(StudyTest::kLevel) +
                     " (" + correction_text(study, *deciding);
  if (concerned.curves.size() > 1) {
    test += "; of the " + std::to_string(concerned.curves.size()) + " tests " +
            (concerned.are_of_effect ? "that the effect concerns" : "of the analysis") +
            ", the one that needs most participants";
  }
  test += ')';
  const std::string simulated = std::to_string(study.runs) +
                                " simulated studies per number of participants (" + study.program +
                                ", protocol " + study.protocol +
                                ", with its plan, procedures, exclusions and analysis)";
  const std::string what = " to detect " + effects_text(study) + " with " + test;
  if (!sample.planned) {
    return "No simulated number of participants has a power of " + percent(power) + what + ": " +
           std::to_string(largest.power.participants) + " participants have a power of " +
           percent(largest.power.power) + ", 95 % Monte-Carlo CI [" +
           percent(largest.power.interval.low) + ", " + percent(largest.power.interval.high) +
           "], in " + simulated + "; " + deviations_text(study) + '.';
  }
  std::string sentence = "A sample of " + std::to_string(*sample.planned) +
                         " participants has a power of at least " + percent(power) + what +
                         "; the smallest number with this power is " +
                         smallest_text(sample.smallest, *deciding) + ", from " + simulated;
  if (study.rules.multiple > 1) {
    sentence +=
        ", rounded up to whole rounds of " + std::to_string(study.rules.multiple) + " participants";
  }
  return sentence + "; " + deviations_text(study) + recruited_text(sample, study.rules.attrition) +
         '.';
}

}  // namespace asperity
