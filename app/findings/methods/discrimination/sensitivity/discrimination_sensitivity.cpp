// Counts hits by level and false alarms, over all levels where noise trials are shared, for the family `dprime`.

#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "analysis/choices/signal_detection.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

/// How the family `dprime` names a design, and the end of its names of d′.
struct NamedDesign {
  std::string_view id{};
  const char* in_family = "";
  QuantityName dprime{};
};
constexpr std::array kNamedDesigns{
    NamedDesign{"two_alternatives", "2afc", "dprime.loglinear"},
    NamedDesign{"yes_no", "yesno", "dprime.loglinear"},
    NamedDesign{"same_different", "samediff", "dprime.diff.loglinear"}};

const NamedDesign& named_design(const DiscriminationDesign& design) {
  return *std::find_if(kNamedDesigns.begin(), kNamedDesigns.end(),
                       [&design](const NamedDesign& each) { return each.id == design.id; });
}

/// The counts of one participant in one condition at one value.
struct CountsAtLevel {
  std::uint32_t person = 0;
  std::size_t condition = 0;
  double value = 0.0;
  DetectionCounts counts{};
};

/// Responses "cannot tell" are on neither side of a criterion, and without them d′ would be too great.
bool is_shown(const DiscriminationResults& results) {
  return results.study.task.is_performance && !results.study.has_levels_of_procedure &&
         !results.study.task.design->is_choice_of_three() && !results.study.has_unsure();
}

void add_response(HitCount& count, bool is_yes) {
  ++count.trials;
  count.hits += is_yes ? 1 : 0;
}

std::vector<CountsAtLevel> counts_by_level(const DiscriminationStudy& study) {
  using OfCondition = std::pair<std::size_t, std::uint32_t>;
  std::map<std::tuple<std::size_t, double, std::uint32_t>, DetectionCounts> by_level{};
  std::map<OfCondition, HitCount> noise{};
  const bool has_noise = study.task.design->has_noise();
  for (const DiscriminationTrial& trial : study.trials) {
    if (!trial.is_signal) {
      add_response(noise[{trial.condition, trial.person}], trial.chose_comparison);
      continue;
    }
    DetectionCounts& counts = by_level[{trial.condition, trial.value, trial.person}];
    if (has_noise || trial.comparison_first) {
      add_response(counts.signal, trial.chose_comparison);
    } else {
      add_response(counts.noise, !trial.chose_comparison);
    }
  }
  std::vector<CountsAtLevel> levels{};
  for (auto& [place, counts] : by_level) {
    const auto& [condition, value, person] = place;
    if (has_noise) counts.noise = noise[{condition, person}];
    if (counts.signal.trials == 0 || counts.noise.trials == 0) continue;
    levels.push_back({.person = person, .condition = condition, .value = value, .counts = counts});
  }
  return levels;
}

FindingKey id_of(const DiscriminationResults& results, const CountsAtLevel& level) {
  return id_of_level(results, {level.condition, level.value});
}

std::vector<Finding> sensitivity_of(const GatheredAnswers& gathered,
                                    const DiscriminationResults& results,
                                    const std::vector<CountsAtLevel>& levels) {
  TidyInput input{};
  LabelRows ids{};
  LabelRows subjects{};
  LabelRows designs{};
  NumberColumn signal_yes{};
  NumberColumn signal_n{};
  NumberColumn noise_yes{};
  NumberColumn noise_n{};
  for (const CountsAtLevel& level : levels) {
    ids.add(input.label_of(id_of(results, level)));
    subjects.add(gathered.people[level.person].label);
    designs.add(named_design(*results.study.task.design).in_family);
    signal_yes.emplace_back(static_cast<double>(level.counts.signal.hits));
    signal_n.emplace_back(static_cast<double>(level.counts.signal.trials));
    noise_yes.emplace_back(static_cast<double>(level.counts.noise.hits));
    noise_n.emplace_back(static_cast<double>(level.counts.noise.trials));
  }
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"id", std::move(ids).take()},
                                                           {"subject", std::move(subjects).take()},
                                                           {"design", std::move(designs).take()},
                                                           {"signal_yes", std::move(signal_yes)},
                                                           {"signal_n", std::move(signal_n)},
                                                           {"noise_yes", std::move(noise_yes)},
                                                           {"noise_n", std::move(noise_n)}},
                            "the responses");
  return analysis_of(kSensitivity, "dprime", std::move(input));
}

const ResultColumn kHitRate{.id = "hit_rate", .heading = phrase("AnalysisWords", "hit rate")};
const ResultColumn kFalseAlarmRate{.id = "false_alarm_rate",
                                   .heading = phrase("AnalysisWords", "false-alarm rate")};
const ResultColumn kCriterion{.id = "criterion", .heading = phrase("AnalysisWords", "criterion")};
const ResultColumn kCriterionK{.id = "criterion_k",
                               .heading = phrase("AnalysisWords", "criterion k, differencing")};
const ResultColumn kDifferent{.id = "different",
                              .heading = phrase("AnalysisWords", "responses “different”")};

void add_level_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                    const std::vector<CountsAtLevel>& levels, const FoundNumbers& found,
                    ResultTable& table) {
  const DiscriminationTask& task = results.study.task;
  const QuantityName dprime = named_design(*task.design).dprime;
  for (const CountsAtLevel& level : levels) {
    const FindingKey key{id_of(results, level), gathered.people[level.person].label};
    const std::string& unit = task.varied.unit;
    table.add({gathered.people[level.person].label, results.conditions[level.condition],
               task.varied.parameter, quantity_cell(level.value, unit),
               quantity_cell(level.value - task.standard(), unit),
               count_cell(level.counts.signal.trials), found.cell("hit", key),
               count_cell(level.counts.noise.trials), found.cell("fa", key),
               found.cell(dprime, key), found.interval(dprime, key),
               found.cell("dprime.io.loglinear", key), found.cell("criterion.loglinear", key),
               found.cell("k.diff.loglinear", key), word_cell(unit)});
  }
}

/// The kinds of the two surfaces in the order of presentation.
std::pair<std::string, std::string> pair_as_presented(const DiscriminationTrial& trial) {
  if (trial.comparisons == 0) return {"standard", "standard"};
  if (trial.comparisons == 2) return {"comparison", "comparison"};
  return trial.comparison_first ? std::pair{"comparison", "standard"}
                                : std::pair{"standard", "comparison"};
}

void add_pair_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                   ResultTable& table) {
  if (results.study.task.design->surfaces() != 2 || !results.study.task.design->has_noise()) return;
  std::map<std::tuple<std::uint32_t, std::size_t, std::pair<std::string, std::string>>, HitCount>
      counts{};
  for (const DiscriminationTrial& trial : results.study.trials) {
    add_response(counts[{trial.person, trial.condition, pair_as_presented(trial)}],
                 trial.chose_comparison);
  }
  for (const auto& [place, count] : counts) {
    const auto& [person, condition, pair] = place;
    table.add({gathered.people[person].label, results.conditions[condition],
               JoinedCell{{pair.first, pair.second}, pair.first + ", " + pair.second},
               count_cell(count.trials), count_cell(count.hits), proportion(count)});
  }
}

/// Whether both rates are 0 or both are 1, and the log-linear correction makes them differ.
bool has_sensitivity_of_correction(const DetectionCounts& counts) {
  const auto& [signal, noise] = counts;
  const bool is_never = signal.hits == 0 && noise.hits == 0;
  const bool is_always = signal.hits == signal.trials && noise.hits == noise.trials;
  return (is_never || is_always) && signal.trials != noise.trials;
}

/// Sentences on the designs that occur. `of_correction`: rows with `has_sensitivity_of_correction`.
Phrase note_on_sensitivity(const std::vector<DiscriminationResults>& all,
                           std::size_t of_correction) {
  std::set<std::string_view> designs{};
  for (const DiscriminationResults& results : all) {
    if (is_shown(results)) designs.insert(results.study.task.design->id);
  }
  Phrase note{};
  const auto add = [&note](const Phrase& sentence) {
    note = note.empty() ? sentence : phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (designs.contains("two_alternatives")) {
    add(phrase("Analysis",
               "Two alternatives: hits are responses “the first” with the comparison as surface A, "
               "false alarms the same responses with the comparison as surface B; "
               "d′ = (z(H) − z(F))/√2 [Macmillan 2005]. A positive criterion is a bias towards "
               "surface B."));
  }
  if (designs.contains("yes_no")) {
    add(phrase("Analysis",
               "Yes/no: hits are responses “yes” to the comparison, false alarms those to the "
               "standard, over all levels of the condition together; d′ = z(H) − z(F) "
               "[Macmillan 2005]. A positive criterion is a reluctance to respond “yes”."));
  }
  if (designs.contains("same_different")) {
    add(phrase("Analysis",
               "Same–different: hits are responses “different” to different surfaces, false "
               "alarms those to equal surfaces, over all levels of the condition together. d′ by "
               "the differencing rule, and d′ by the rule of independent observations [Macmillan "
               "2005]. By the differencing rule the response is “different” where two impressions "
               "differ by more than the criterion k, which is estimated from the false alarms, in "
               "standard deviations of an impression."));
  }
  add(phrase("Analysis",
             "d′ is computed with the log-linear correction of the proportions [Hautus 1995], its "
             "95 % CI by the delta method."));
  if (designs.contains("same_different")) {
    add(phrase("Analysis",
               "Same–different: there is no CI of d′ where it would contain negative values, which "
               "d′ cannot have by these rules."));
  }
  if (of_correction > 0) {
    add(phrase("Analysis",
               "Rows in which the hit rate and the false-alarm rate are both 0 or both 1, with "
               "different numbers of trials with and without a signal: %1. Their d′ depends on "
               "these numbers alone, because the corrected rates, (responses + ½)/(trials + 1), "
               "are equal only for equal numbers. With more trials without a signal, it is above "
               "0 if both rates are 0, and below 0 (same–different: 0) if both are 1.")
            .with(std::to_string(of_correction)));
  }
  return note;
}

/// Whether d′ without a correction would be positive and infinite.
bool is_at_ceiling(const DetectionCounts& counts) {
  const auto& [signal, noise] = counts;
  const bool has_all_hits = signal.hits == signal.trials && noise.hits < noise.trials;
  return has_all_hits || (noise.hits == 0 && signal.hits > 0);
}

/// Whether it would be negative and infinite. Same–different has no negative d′.
bool is_at_floor(const DetectionCounts& counts, const DiscriminationDesign& design) {
  if (named_design(design).id == "same_different") return false;
  const auto& [signal, noise] = counts;
  const bool has_all_false_alarms = noise.hits == noise.trials && signal.hits < signal.trials;
  return has_all_false_alarms || (signal.hits == 0 && noise.hits > 0);
}

/// "7.5 µm: 1.2 (95 % CI [0.9, 1.5])", for all conditions and levels.
Phrase mean_sensitivities(const DiscriminationResults& results, const UnboundedAtLevels& levels,
                          const FoundNumbers& found) {
  Phrase all{};
  for (const auto& [place, of] : levels) {
    const Finding* const mean = found.find("dprime.mean", id_of_level(results, place));
    if (mean == nullptr || !mean->value) continue;
    Phrase one = phrase("Analysis", "%1: %2")
                     .with(stated_quantity(place.second, results.study.task.varied.unit),
                           display_number(*mean->value));
    if (mean->low && mean->high) {
      one = phrase("Analysis", "%1 (95 % CI [%2, %3])")
                .with(one, display_number(*mean->low), display_number(*mean->high));
    }
    if (of.is_any()) one = with_bound(one, of);
    if (results.conditions.size() > 1) {
      one = phrase("Analysis", "%1, %2")
                .with(words_of_condition(results.conditions[place.first]), one);
    }
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

/// The delta method has no valid limits where d′ is near 0 and cannot be negative.
void drop_impossible_intervals(const DiscriminationDesign& design, std::vector<Finding>& findings) {
  if (named_design(design).id != "same_different") return;
  drop_intervals(findings, [](const Finding& finding) -> std::optional<std::string> {
    const bool is_negative = finding.low && *finding.low < 0.0;
    if (!finding.quantity.starts_with("dprime.") || !is_negative) return std::nullopt;
    return "without an interval, because that of the delta method contains negative values, which "
           "d′ cannot have by this rule";
  });
}

void count_zeros(const GatheredAnswers& gathered, const DiscriminationResults& results,
                 const std::vector<CountsAtLevel>& levels, const FoundNumbers& found,
                 UnboundedAtLevels& places) {
  const NamedDesign& named = named_design(*results.study.task.design);
  if (named.id != "same_different") return;
  for (const CountsAtLevel& level : levels) {
    const FindingKey key{id_of(results, level), gathered.people[level.person].label};
    if (found.value(named.dprime, key) == 0.0) ++places[{level.condition, level.value}].at_zero;
  }
}

/// Participants and levels with trials of which one kind is missing, so that there is no d′.
std::size_t levels_without_noise(const DiscriminationStudy& study, std::size_t with_both) {
  std::set<std::tuple<std::size_t, double, std::uint32_t>> all{};
  for (const DiscriminationTrial& trial : study.trials) {
    if (trial.is_signal) all.emplace(trial.condition, trial.value, trial.person);
  }
  return all.size() - std::min(all.size(), with_both);
}

}  // namespace

std::string_view name_in_family(const DiscriminationDesign& design) {
  return named_design(design).in_family;
}

std::map<std::pair<std::size_t, std::uint32_t>, std::optional<double>> sensitivities_at_only_level(
    const GatheredAnswers& gathered, const DiscriminationResults& results) {
  if (!is_shown(results)) return {};
  const std::vector<CountsAtLevel> levels = counts_by_level(results.study);
  const bool has_several = std::any_of(levels.begin(), levels.end(), [&levels](const auto& level) {
    return level.value != levels.front().value;
  });
  if (levels.empty() || has_several) return {};
  const std::vector<Finding> findings = sensitivity_of(gathered, results, levels);
  const FoundNumbers found(findings);
  const DiscriminationDesign& design = *results.study.task.design;
  std::map<std::pair<std::size_t, std::uint32_t>, std::optional<double>> sensitivities{};
  for (const CountsAtLevel& level : levels) {
    const bool is_bound = is_at_ceiling(level.counts) || is_at_floor(level.counts, design);
    const FindingKey key{id_of(results, level), gathered.people[level.person].label};
    sensitivities[{level.condition, level.person}] =
        is_bound ? std::nullopt : found.value(named_design(design).dprime, key);
  }
  return sensitivities;
}

void ask_mean_sensitivity(const DiscriminationResults& results, const UnboundedAtLevels& levels,
                          const FoundNumbers& found, const MeanSensitivity& mean,
                          AnalysisOutcome& outcome) {
  const Phrase means = mean_sensitivities(results, levels, found);
  if (means.empty()) return;
  const Phrase answer =
      explained_bounds(phrase("Analysis", "Mean d′ by the %1 of the comparison: %2.")
                           .with(words_of_parameter(results.study.task.varied.parameter), means),
                       levels, results);
  const std::string name =
      results.name.empty() ? kSensitivity : std::string(kSensitivity) + ':' + results.name;
  add_question(outcome, name.c_str(),
               phrase("Analysis", "How large is the sensitivity (d′) at each level?"), answer,
               mean.method, mean.table,
               found.find("dprime.mean", id_of_level(results, levels.begin()->first)));
}

void add_sensitivity(const GatheredAnswers& gathered, const std::vector<DiscriminationResults>& all,
                     AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable sensitivity{
      kSensitivity,
      phrase("Analysis", "Sensitivity by level"),
      {kParticipant, kCondition, kParameterColumn, kLevelColumn, kDifference, kSignalTrials,
       kHitRate, kNoiseTrials, kFalseAlarmRate, kDPrime, interval_of(kDPrime), kDPrimeIndependent,
       kCriterion, kCriterionK, kUnitOfLevels}};
  ResultTable pairs{kResponsesByPair,
                    phrase("Analysis", "Responses by pair of surfaces"),
                    {kParticipant, kCondition, kPair, kResponses, kDifferent, kShare},
                    phrase("Analysis",
                           "Responses “different” to every pair of surfaces, in the order of "
                           "presentation (side by side: A, B), over all levels together.")};
  std::size_t of_correction = 0;
  std::size_t without_noise = 0;
  for (const DiscriminationResults& results : all) {
    if (!is_shown(results)) continue;
    const std::vector<CountsAtLevel> levels = counts_by_level(results.study);
    if (levels.empty()) continue;
    of_correction += static_cast<std::size_t>(std::count_if(
        levels.begin(), levels.end(),
        [](const CountsAtLevel& level) { return has_sensitivity_of_correction(level.counts); }));
    UnboundedAtLevels places{};
    for (const CountsAtLevel& level : levels) {
      UnboundedParticipants& of = places[{level.condition, level.value}];
      ++of.participants;
      of.at_ceiling += is_at_ceiling(level.counts) ? 1 : 0;
      of.at_floor += is_at_floor(level.counts, *results.study.task.design) ? 1 : 0;
    }
    std::vector<Finding> findings = sensitivity_of(gathered, results, levels);
    drop_impossible_intervals(*results.study.task.design, findings);
    count_zeros(gathered, results, levels, FoundNumbers(findings), places);
    without_noise += levels_without_noise(results.study, levels.size());
    mark_bounds(results, places, findings);
    keep_findings(findings, outcome);
    const FoundNumbers found(findings);
    add_level_rows(gathered, results, levels, found, sensitivity);
    add_pair_rows(gathered, results, pairs);
    if (!results.study.task.design->has_noise()) continue;
    ask_mean_sensitivity(
        results, places, found,
        {.table = kSensitivity,
         .method = phrase("Analysis",
                          "Mean over the participants of d′ with the log-linear correction; CIs by "
                          "expanded percentiles of a bootstrap over participants, with six "
                          "participants or more.")},
        outcome);
  }
  if (sensitivity.rows.empty()) return;
  sensitivity.note = note_on_sensitivity(all, of_correction);
  if (without_noise > 0) {
    sensitivity.note =
        phrase("Analysis",
               "%1 Participants and levels without a row: %2, because all of their trials at the "
               "level had the comparison in the same position, or there were no trials without a "
               "signal.")
            .with(sensitivity.note, std::to_string(without_noise));
  }
  sensitivity.drop_empty_columns(2);
  outcome.tables.push_back(std::move(sensitivity));
  if (!pairs.rows.empty()) outcome.tables.push_back(std::move(pairs));
}

}  // namespace asperity
