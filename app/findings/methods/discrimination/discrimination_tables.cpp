// Adds the rows of every task to common tables, whose notes explain only the methods that the rows need.

#include "app/findings/methods/discrimination/discrimination_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "app/findings/methods/discrimination/catch/catch_exclusions.h"
#include "app/findings/methods/discrimination/sensitivity/choice_sensitivity.h"
#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"
#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"
#include "app/findings/methods/discrimination/thresholds/detection_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_coverage.h"
#include "app/findings/methods/discrimination/thresholds/left_out_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/missing_threshold.h"
#include "app/findings/methods/discrimination/thresholds/study_track_figures.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/methods/discrimination/thresholds/threshold_figures.h"
#include "app/findings/methods/discrimination/thresholds/unforced_functions.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "protocols/design/block_factors.h"

namespace asperity {

namespace {

const ResultColumn kDeviance{
    .id = "deviance", .heading = phrase("AnalysisWords", "deviance"), .digits = Digits::statistic};
const ResultColumn kUnfinishedTracks{.id = "unfinished_tracks",
                                     .heading = phrase("AnalysisWords", "unfinished tracks")};
/// Of the simulated repetitions of a procedure (kRepetitionsOfProcedure).
const ResultColumn kWithoutThreshold{
    .id = "without_threshold", .heading = phrase("AnalysisWords", "repetitions without threshold")};
const ResultColumn kRepetitionsOfProcedure{.id = "repetitions", .is_for_files = true};
const ResultColumn kFirstResponses{
    .id = "first_responses", .heading = phrase("AnalysisWords", "responses, comparison first")};
const ResultColumn kShareFirst{.id = "share_first",
                               .heading = phrase("AnalysisWords", "comparison chosen, first"),
                               .digits = Digits::bounded};
const ResultColumn kSecondResponses{
    .id = "second_responses", .heading = phrase("AnalysisWords", "responses, comparison second")};
const ResultColumn kShareSecond{.id = "share_second",
                                .heading = phrase("AnalysisWords", "comparison chosen, second"),
                                .digits = Digits::bounded};
const ResultColumn kChosenA{.id = "chosen_a", .heading = phrase("AnalysisWords", "A chosen")};
const ResultColumn kChosenB{.id = "chosen_b", .heading = phrase("AnalysisWords", "B chosen")};
const ResultColumn kChosenC{.id = "chosen_c", .heading = phrase("AnalysisWords", "C chosen")};

/// A threshold without a number, and the word of the reason.
struct MissingMeasure {
  std::string measure{};  ///< the id of its column
  std::string word{};
};

/// "jnd, weber: below_levels; jnd_dprime1: above_levels"; missing where no number is.
ResultCell reasons_cell(const std::vector<MissingMeasure>& missing) {
  std::vector<std::pair<std::string, std::string>> measures{};  // word → measures
  for (const MissingMeasure& each : missing) {
    const auto known = std::find_if(measures.begin(), measures.end(),
                                    [&each](const auto& one) { return one.first == each.word; });
    if (known == measures.end()) {
      measures.emplace_back(each.word, each.measure);
    } else {
      known->second += ", " + each.measure;
    }
  }
  std::string text{};
  for (const auto& [word, of] : measures) text += (text.empty() ? "" : "; ") + of + ": " + word;
  return word_cell(text);
}

/// Whether the slope is at the bound of the fit, so that its thresholds have no interval; that of a procedure has limits.
bool is_without_interval_at_bound(const DiscriminationResults& results,
                                  const DiscriminationResults::Function& function,
                                  const FoundNumbers& functions) {
  const Finding* const at_bound = functions.find("bound.beta", function.data.key);
  const bool has_limits = results.study.task.is_performance && function.data.by_procedure;
  return !has_limits && at_bound != nullptr && at_bound->word == "TRUE";
}

/// "22/500": repetitions without a threshold, of all.
ResultCell cell_of_repetitions(const Finding& without) {
  if (!without.value) return {};
  const auto count = static_cast<std::int64_t>(std::llround(*without.value));
  return JoinedCell{{count}, std::to_string(count) + '/' + std::to_string(without.n)};
}

void add_threshold_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                        ResultTable& table) {
  const FoundNumbers thresholds(results.fit.thresholds);
  const FoundNumbers functions(results.fit.functions);
  for (const auto& function : results.functions) {
    const FindingKey& key = function.data.key;
    ResultRow row{gathered.people[function.person].label, results.conditions[function.condition]};
    const std::string& unit_of_levels = results.study.task.varied.unit;
    std::vector<MissingMeasure> missing{};
    for (const ThresholdColumn& column : kThresholdColumns) {
      const std::string unit = column.has_unit_of_levels ? unit_of_levels : std::string();
      const Finding* const finding = thresholds.find(column.quantity, key);
      if (finding == nullptr) {
        row.resize(row.size() + 2);
        continue;
      }
      row.push_back(quantity_cell(finding->value, unit));
      row.push_back(interval_cell(finding->low, finding->high, unit));
      if (!finding->value) missing.push_back({column.column.id, finding->word});
    }
    ResultCell why = reasons_cell(missing);
    if (why == ResultCell{} && is_without_interval_at_bound(results, function, functions)) {
      why = std::string("slope_at_bound");  // and therefore without an interval
    }
    const Finding* const at_unit = thresholds.find("jnd.dprime1", key);
    if (why == ResultCell{} && results.study.task.design->has_noise() && at_unit != nullptr &&
        at_unit->value && !at_unit->low) {
      why = std::string("jnd_dprime1: no_interval");
    }
    std::int64_t responses = 0;
    for (const auto& [value, count] : function.data.hits) {
      responses += static_cast<std::int64_t>(count.trials);
    }
    row.push_back(functions.cell("deviance", key));
    row.push_back(functions.count("deviance.df", key));
    row.push_back(functions.cell("deviance.p.chisq", key));
    row.emplace_back(responses);
    row.push_back(thresholds.count("unfinished.tracks", key));
    const Finding* const without = thresholds.find("without", key);
    row.push_back(without == nullptr ? ResultCell{} : cell_of_repetitions(*without));
    row.push_back(word_cell(unit_of_levels));
    row.push_back(why);
    row.push_back(without == nullptr ? ResultCell{} : count_cell(without->n));
    table.add(std::move(row));
  }
}

void add_mean_rows(const DiscriminationResults& results, ResultTable& table) {
  const FoundNumbers means(results.means);
  for (const ThresholdColumn& column : kThresholdColumns) {
    for (const std::string& condition : results.conditions) {
      const Finding* const mean = means.find(column.mean, condition);
      if (mean == nullptr) continue;
      const LeftOutThresholds left_out = left_out_of_mean(results.fit.thresholds, *mean);
      const std::string status = code_of(left_out.mean());
      const Finding* const of_logarithms = means.find(column.geometric_mean, condition);
      table.add({condition, column.column.id, count_cell(mean->n),
                 quantity_cell(mean->value, mean->unit),
                 interval_cell(mean->low, mean->high, mean->unit), mean->unit,
                 of_logarithms == nullptr ? ResultCell{}
                                          : quantity_cell(of_logarithms->value, mean->unit),
                 of_logarithms == nullptr
                     ? ResultCell{}
                     : interval_cell(of_logarithms->low, of_logarithms->high, mean->unit),
                 left_out.missing() == 0 ? ResultCell{} : count_cell(left_out.missing()),
                 word_cell(status)});
    }
  }
}

/// A whole number where no response is "cannot tell".
ResultCell hits_cell(const DiscriminationTask& task, const ChoiceCount& count) {
  if (count.unsure == 0) return static_cast<std::int64_t>(count.hits);
  return split_hits(count, task.design->alternatives());
}

double share_of(const DiscriminationTask& task, const ChoiceCount& count) {
  return split_proportion(count, task.design->alternatives());
}

void add_unsure_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                     ResultTable& table) {
  const FoundNumbers rates(results.unsure);
  if (results.unsure.empty()) return;
  for (const auto& function : results.functions) {
    const ChoiceCount all = sum_of_choices(function.data.hits);
    table.add({gathered.people[function.person].label, results.conditions[function.condition],
               count_cell(all.unsure), count_cell(all.trials),
               rates.cell("rate", function.data.key), rates.interval("rate", function.data.key)});
  }
}

void add_psychometric_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                           ResultTable& table) {
  const DiscriminationTask& task = results.study.task;
  for (const auto& function : results.functions) {
    for (const auto& [value, count] : function.data.hits) {
      const std::string& unit = task.varied.unit;
      table.add({gathered.people[function.person].label, results.conditions[function.condition],
                 task.varied.parameter, quantity_cell(value, unit),
                 task.is_performance ? quantity_cell(value - task.standard(), unit) : ResultCell{},
                 count_cell(count.trials), hits_cell(task, count), share_of(task, count),
                 word_cell(unit), count.unsure == 0 ? ResultCell{} : count_cell(count.unsure)});
    }
  }
}

void add_order_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                    ResultTable& table) {
  // Over levels that a procedure chose, only the difference of the proportions has a meaning.
  const bool hides_proportions = results.study.has_levels_of_procedure;
  for (const OrderOfPerson& own : results.orders) {
    const auto share = [&](const ChoiceCount& count) {
      return hides_proportions || count.trials == 0 ? ResultCell{}
                                                    : ResultCell{own.proportion_of(count)};
    };
    table.add({gathered.people[own.person].label, word_cell(results.name),
               count_cell(own.first.trials), share(own.first), count_cell(own.second.trials),
               share(own.second), own.has_both() ? ResultCell{own.difference()} : ResultCell{}});
  }
}

/// 1, 0, or the part of a hit of a response "cannot tell".
ResultCell hit_cell(const DiscriminationStudy& study, const DiscriminationTrial& trial) {
  if (!trial.is_unsure) return static_cast<std::int64_t>(study.is_hit(trial) ? 1 : 0);
  return 1.0 / static_cast<double>(study.task.design->alternatives());
}

void add_place_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                    ResultTable& table) {
  for (const PlacesOfPerson& own : results.places) {
    ResultRow row{gathered.people[own.person].label, word_cell(results.name),
                  count_cell(own.responses())};
    for (std::size_t place = 0; place < kPlacesOfChoice; ++place) {
      row.push_back(own.has_all() ? ResultCell{own.proportion_of(place)} : ResultCell{});
    }
    table.add(std::move(row));
  }
}

void add_track_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
                    ResultTable& table) {
  const DiscriminationStudy& study = results.study;
  std::vector<const DiscriminationTrial*> of_tracks{};
  for (const DiscriminationTrial& trial : study.trials) {
    if (trial.by_procedure) of_tracks.push_back(&trial);
  }
  const auto place = [](const DiscriminationTrial& trial) {
    return std::tie(trial.person, trial.session, trial.block_ordinal, trial.track, trial.step);
  };
  std::stable_sort(of_tracks.begin(), of_tracks.end(),
                   [&place](const DiscriminationTrial* one, const DiscriminationTrial* other) {
                     return place(*one) < place(*other);
                   });
  for (const DiscriminationTrial* const trial : of_tracks) {
    const std::string& unit = study.task.varied.unit;
    table.add({gathered.people[trial->person].label, results.conditions[trial->condition],
               static_cast<std::int64_t>(trial->session),
               static_cast<std::int64_t>(trial->block_ordinal),
               static_cast<std::int64_t>(trial->track), static_cast<std::int64_t>(trial->step),
               quantity_cell(trial->value, unit), hit_cell(study, *trial), word_cell(unit)});
  }
}

std::vector<BlockWithProcedure> blocks_with_procedure(
    const GatheredAnswers& gathered, const std::vector<DiscriminationResults>& all) {
  std::vector<BlockWithProcedure> blocks{};
  for (const auto& [name, block] : gathered.blocks) {
    const std::optional<DiscriminationTask> task = discrimination_task(name, block);
    if (!task || !chooses_levels_from_answers(block)) continue;
    const bool is_analysed = std::any_of(
        all.begin(), all.end(), [&task](const auto& each) { return each.study.task == *task; });
    const bool is_simulated = task->is_performance && task->design == &two_alternatives();
    if (is_analysed) blocks.push_back({.block = &block, .is_performance = is_simulated});
  }
  return blocks;
}

/// Which functions a table contains, and therefore which methods its note explains.
struct ShownFunctions {
  bool has_performance = false;  ///< of two alternatives
  bool has_three_alternatives = false;
  bool has_oddity = false;
  bool has_comparison = false;
  bool has_delta_performance = false;
  bool has_delta_comparison = false;
  bool has_limited_slopes = false;
  bool has_repeated_procedure = false;
  bool has_unfinished_tracks = false;
  bool has_posterior = false;
  bool has_unsure = false;
  // With constant levels and responses "cannot tell":
  bool has_unforced_comparison = false;
  bool has_unforced_performance = false;
  bool has_resamples = false;  ///< bootstrap intervals of functions with such responses
  bool has_deviance = false;
  bool has_yes_no = false;
  bool has_same_different = false;
};

ShownFunctions shown_functions(const std::vector<DiscriminationResults>& all) {
  ShownFunctions shown{};
  for (const DiscriminationResults& results : all) {
    const bool is_performance = results.study.task.is_performance;
    const DiscriminationDesign& design = *results.study.task.design;
    const FoundNumbers thresholds(results.fit.thresholds);
    shown.has_deviance =
        shown.has_deviance || !FoundNumbers(results.fit.functions).all("deviance").empty();
    if (const auto detection = detection_task(*results.study.task.design)) {
      shown.has_yes_no = shown.has_yes_no || *detection == DetectionTask::yes_no;
      shown.has_same_different =
          shown.has_same_different || *detection == DetectionTask::same_different;
      continue;
    }
    for (const auto& function : results.functions) {
      const bool by_procedure = function.data.by_procedure;
      const bool is_of_three = design.is_choice_of_three();
      shown.has_performance = shown.has_performance || (is_performance && !is_of_three);
      shown.has_three_alternatives =
          shown.has_three_alternatives || (is_of_three && !design.asks_for_odd_one);
      shown.has_oddity = shown.has_oddity || design.asks_for_odd_one;
      shown.has_comparison = shown.has_comparison || !is_performance;
      const bool has_delta = !by_procedure && !has_unsure(function.data);
      shown.has_delta_performance = shown.has_delta_performance || (is_performance && has_delta);
      shown.has_delta_comparison = shown.has_delta_comparison || (!is_performance && has_delta);
      shown.has_unsure = shown.has_unsure || has_unsure(function.data);
      shown.has_resamples = shown.has_resamples || (!by_procedure && has_unsure(function.data));
      if (!by_procedure && has_unsure(function.data)) {
        (is_performance ? shown.has_unforced_performance : shown.has_unforced_comparison) = true;
      }
      shown.has_limited_slopes = shown.has_limited_slopes || (is_performance && by_procedure);
      shown.has_repeated_procedure =
          shown.has_repeated_procedure || thresholds.find("without", function.data.key) != nullptr;
      shown.has_unfinished_tracks =
          shown.has_unfinished_tracks ||
          thresholds.find("unfinished.tracks", function.data.key) != nullptr;
      shown.has_posterior =
          shown.has_posterior || thresholds.find("jnd.posterior", function.data.key) != nullptr;
    }
  }
  return shown;
}

Phrase note_on_thresholds(const GatheredAnswers& gathered,
                          const std::vector<DiscriminationResults>& all) {
  const ShownFunctions shown = shown_functions(all);
  Phrase note{};
  const auto add = [&note](const Phrase& sentence) {
    note = note.empty() ? sentence : phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (shown.has_performance) {
    add(phrase("Analysis",
               "Performance: a Weibull function of the difference from the standard, fitted by "
               "maximum likelihood with a guess rate of 1/2 and a lapse rate between 0 and 6 %. "
               "JND: the difference at 75 % correct responses; JND at d′ = 1: at 76 %."));
  }
  if (shown.has_three_alternatives) {
    add(phrase("Analysis",
               "Three alternatives: a Weibull function of the difference from the standard, fitted "
               "by maximum likelihood with a guess rate of 1/3 and a lapse rate between 0 and 6 %. "
               "JND: the difference at 66.7 % correct responses; JND at d′ = 1: at 63.4 % "
               "[Hacker 1979]."));
  }
  if (shown.has_oddity) {
    add(phrase("Analysis",
               "Oddity: a Weibull function of the difference from the standard, fitted by maximum "
               "likelihood with a guess rate of 1/3 and a lapse rate between 0 and 6 %. JND: the "
               "difference at 66.7 % correct responses; JND at d′ = 1: at 41.8 %, by the "
               "differencing rule [Frijters 1979]."));
  }
  if (shown.has_yes_no) {
    add(phrase("Analysis",
               "Yes/no: responses are modelled as P(yes) = Φ(d′ − k) with d′ = (x/α)^β, x the "
               "difference from the standard and 2 % lapses in both directions, by maximum "
               "likelihood. JND at d′ = 1: α [Macmillan 2005]; 95 % CI: Wald, on the logarithmic "
               "scale."));
  }
  if (shown.has_same_different) {
    add(phrase("Analysis",
               "Same–different: responses are modelled by the differencing rule, P(different) = "
               "Φ((d′ − k)/√2) + Φ((−d′ − k)/√2) with d′ = (x/α)^β, x the difference from the "
               "standard and 2 % lapses in both directions, by maximum likelihood. JND at d′ = 1: "
               "α [Macmillan 2005]; 95 % CI: Wald, on the logarithmic scale."));
  }
  if (shown.has_yes_no || shown.has_same_different) {
    add(phrase("Analysis",
               "There is no CI where its limits would differ by a factor of more than 100, because "
               "the responses hardly determine such a threshold."));
  }
  if (shown.has_delta_performance) {
    add(phrase("Analysis", "95 % CI: delta method, truncated at 0."));
  }
  if (shown.has_comparison) {
    add(phrase("Analysis",
               "Comparison: a cumulative normal function of the parameter, fitted by maximum "
               "likelihood with lapse rates of 2 % in both directions. PSE: the value at which "
               "both responses are equally frequent; JND: half the distance between the values at "
               "25 % and 75 %, without lapses."));
  }
  if (shown.has_delta_comparison) {
    add(phrase("Analysis", "95 % CI: delta method, for the JND on the logarithmic scale."));
  }
  if (shown.has_unsure) {
    add(phrase("Analysis",
               "Each response “cannot tell” counts as the mean of a guess: 1/m of a hit, with m "
               "alternatives [Kaernbach 2001]. Split counts are not binomial, so that the goodness "
               "of fit of these functions is not tested."));
  }
  if (shown.has_resamples) {
    add(phrase(
            "Analysis",
            "95 % CI with responses “cannot tell”: bootstrap percentiles, the three outcomes of "
            "each level being resampled %1 times and split again. There is no CI of the slope "
            "where that of more than 2.5 % of the resampled functions is at the bound of the fit, "
            "which would be its limit.")
            .with(std::to_string(kUnforcedResamples)));
    if (shown.has_unforced_comparison) {
      add(phrase("Analysis", "The JND, which follows from the slope, then has no CI either."));
    }
  }
  if (shown.has_unforced_performance) add(note_on_unforced_jnd(true));
  if (shown.has_unforced_comparison) add(note_on_unforced_jnd(false));
  if (shown.has_limited_slopes) {
    add(phrase("Analysis",
               "With an adaptive procedure, the slope of a Weibull function is limited to %1 to "
               "%2.")
            .with(display_number(kSlopesOfProcedures.least),
                  display_number(kSlopesOfProcedures.greatest)));
  }
  if (shown.has_repeated_procedure) {
    add(phrase("Analysis",
               "With an adaptive procedure, the 95 % CI is a likelihood-ratio interval whose "
               "critical value is found by running the procedure again with simulated observers "
               "(%1 repetitions; those without a threshold are counted in the table).")
            .with(std::to_string(kRepetitionsOfProcedures)));
    const std::vector<BlockWithProcedure> blocks = blocks_with_procedure(gathered, all);
    if (const Phrase coverage = note_on_coverage(blocks); !coverage.empty()) add(coverage);
  }
  if (shown.has_unfinished_tracks) {
    add(phrase("Analysis",
               "Unfinished tracks: tracks that were begun and not finished, because the session "
               "ended before the procedure stopped. The threshold "
               "is estimated from the presented trials and is included in the means and tests if "
               "it lies within the presented levels, the condition for every threshold."));
  }
  if (shown.has_posterior) {
    add(phrase("Analysis",
               "Posterior JND: mean of the posterior distribution of the JND on the logarithmic "
               "scale, with the prior of the procedure, and its 95 % credible interval (CrI)."));
  }
  add(phrase("Analysis",
             "Weber fraction: JND divided by the standard. Thresholds outside the presented levels "
             "are not reported."));
  if (shown.has_deviance) {
    add(phrase("Analysis",
               "Deviance with its degrees of freedom and p (χ²): goodness of fit, indicative only "
               "with few trials per level."));
  }
  std::vector<Phrase> reasons{};
  const auto add_reason = [&reasons](const Phrase& reason) {
    if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) {
      reasons.push_back(reason);
    }
  };
  for (const DiscriminationResults& results : all) {
    for (const Phrase& reason : results.fit.reasons) add_reason(reason);
    const FoundNumbers functions(results.fit.functions);
    for (const auto& function : results.functions) {
      if (is_without_interval_at_bound(results, function, functions)) {
        add_reason(slope_at_bound().sentence);
      }
    }
  }
  if (!reasons.empty()) {
    Phrase listed = reasons.front();
    for (std::size_t i = 1; i < reasons.size(); ++i) {
      listed = phrase("Analysis", "%1; %2").with(listed, reasons[i]);
    }
    add(phrase("Analysis", "Reasons for missing numbers: %1.").with(listed));
  }
  return note;
}

Phrase note_on_means(const std::vector<DiscriminationResults>& all) {
  const bool has_geometric =
      std::any_of(all.begin(), all.end(), [](const DiscriminationResults& results) {
        return std::any_of(results.means.begin(), results.means.end(), [](const Finding& mean) {
          return mean.quantity.starts_with("geomean.");
        });
      });
  const Phrase means = phrase("Analysis",
                              "Means over the participants whose threshold could be estimated, "
                              "with t-based 95 % CIs.");
  Phrase note = means;
  if (has_geometric) {
    note = phrase("Analysis", "%1 %2")
               .with(means,
                     phrase("Analysis",
                            "The CIs of geometric means are computed on the logarithmic scale and "
                            "contain no negative numbers; the CIs of arithmetic means can contain "
                            "them if the participants differ greatly."));
  }
  const bool has_fixed_lapses = std::any_of(all.begin(), all.end(), [](const auto& results) {
    return !results.study.task.is_performance || detection_task(*results.study.task.design);
  });
  if (has_fixed_lapses) {
    note = phrase("Analysis", "%1 %2")
               .with(note,
                     phrase("Analysis",
                            "The CIs of means take lapse rates that are fixed at 2 % as known: in "
                            "simulations of comparisons by participants who never lapse they "
                            "contained the true JND in 22 to 95 % of the studies, in fewer of them "
                            "the more participants and trials there were, and in 91 to 96 % with "
                            "lapse rates of 2 %."));
  }
  const bool leaves_out = std::any_of(all.begin(), all.end(), [](const auto& results) {
    return std::any_of(results.means.begin(), results.means.end(), [&results](const Finding& mean) {
      return left_out_of_mean(results.fit.thresholds, mean).missing() > 0;
    });
  });
  if (!leaves_out) return note;
  return phrase("Analysis", "%1 %2")
      .with(note,
            phrase(
                "Analysis",
                "A mean that leaves out thresholds is an upper bound if all of these lie below the "
                "presented levels, a lower bound if all lie above, and otherwise neither and not "
                "reported. It has no CI: in simulations in which 27 and 34 % of the thresholds "
                "were left out, the t-based CI of the others contained the true mean in 75 and "
                "48 % of the studies."));
}

Phrase note_on_hits_of(const DiscriminationStudy& study) {
  if (const auto detection = detection_task(*study.task.design)) {
    return *detection == DetectionTask::yes_no
               ? phrase("Analysis",
                        "Hits are responses “yes”; those at a difference of 0 are false alarms.")
               : phrase("Analysis",
                        "Hits are responses “different”; those at a difference of 0 are false "
                        "alarms, to all pairs of equal surfaces: two standards, or two comparisons "
                        "of any level.");
  }
  if (study.task.is_performance) return phrase("Analysis", "Hits are correct responses.");
  return study.counts_standard
             ? phrase("Analysis",
                      "Hits are choices of the standard, because the comparison was chosen less "
                      "often at higher levels.")
             : phrase("Analysis", "Hits are choices of the comparison.");
}

/// One sentence where it holds for all tasks, otherwise one for each.
Phrase note_on_hits(const std::vector<DiscriminationResults>& all) {
  const Phrase first = note_on_hits_of(all.front().study);
  if (std::all_of(all.begin(), all.end(), [&first](const DiscriminationResults& each) {
        return note_on_hits_of(each.study) == first;
      })) {
    return first;
  }
  Phrase note{};
  for (const DiscriminationResults& results : all) {
    const Phrase of_task =
        phrase("Analysis", "%1: %2").with(results.name, note_on_hits_of(results.study));
    note = note.empty() ? of_task : phrase("Analysis", "%1 %2").with(note, of_task);
  }
  return note;
}

Phrase note_on_catch_trials(const GatheredAnswers& gathered) {
  const auto has = [&gathered](CatchType type) {
    return std::any_of(gathered.catch_responses.begin(), gathered.catch_responses.end(),
                       [type](const CatchResponses& each) { return each.type == type; });
  };
  Phrase note{};
  const auto add = [&note](const Phrase& sentence) {
    note = note.empty() ? sentence : phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (has(CatchType::easy)) {
    add(phrase("Analysis",
               "Trials with an easy level at random places among the others. Errors and missed "
               "deadlines indicate lapses of attention. No threshold is estimated from these "
               "trials."));
  }
  if (has(CatchType::no_signal)) {
    add(phrase("Analysis",
               "No signal: the standard was presented twice, and “cannot tell” is correct. Every "
               "choice is a false alarm."));
  }
  if (has(CatchType::identical_pair)) {
    add(phrase("Analysis",
               "Identical pair: the standard was presented twice, and “cannot tell” is correct. "
               "Every choice is an error."));
  }
  return note;
}

}  // namespace

void add_discrimination_tables(const GatheredAnswers& gathered,
                               const std::vector<DiscriminationResults>& all,
                               AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable means{kMeanThresholds,
                    phrase("Analysis", "Mean thresholds"),
                    {kCondition, kMeasure, kPersons, kMean, interval_of(kMean), kUnitOfLevels,
                     kGeometricMean, interval_of(kGeometricMean), kLeftOut, kStatus},
                    note_on_means(all)};
  ResultTable thresholds{kThresholds,
                         phrase("Analysis", "Thresholds of the participants"),
                         {kParticipant, kCondition},
                         note_on_thresholds(gathered, all)};
  for (const ThresholdColumn& column : kThresholdColumns) {
    thresholds.columns.insert(thresholds.columns.end(), {column.column, column.interval});
  }
  thresholds.columns.insert(thresholds.columns.end(),
                            {kDeviance, kDf, kP, kResponses, kUnfinishedTracks, kWithoutThreshold,
                             kUnitOfLevels, kStatus, kRepetitionsOfProcedure});
  ResultTable psychometric{kPsychometric,
                           phrase("Analysis", "Responses by level"),
                           {kParticipant, kCondition, kParameterColumn, kLevelColumn, kDifference,
                            kResponses, kHits, kShare, kUnitOfLevels, kUnsureColumn},
                           note_on_hits(all)};
  ResultTable order{
      kOrderEffect,
      phrase("Analysis", "Choices of the comparison by its position"),
      {kParticipant, kTask, kFirstResponses, kShareFirst, kSecondResponses, kShareSecond,
       kDifference},
      phrase("Analysis",
             "Proportions of choices of the comparison as surface A and as surface B, and "
             "their difference (A − B). In a sequence A is presented first.")};
  ResultTable places{
      kChoicesByPlace,
      phrase("Analysis", "Choices by position"),
      {kParticipant, kTask, kResponses, kChosenA, kChosenB, kChosenC},
      phrase("Analysis",
             "Proportions of choices of each of the three surfaces, averaged over the positions of "
             "the correct one; 1/3 without a preference. In a sequence A is presented first.")};
  ResultTable tracks{kTracks,
                     phrase("Analysis", "Trials of each track"),
                     {kParticipant, kCondition, kSession, kBlockOrdinal, kTrackColumn, kStepColumn,
                      kLevelColumn, kHitColumn, kUnitOfLevels},
                     phrase("Analysis",
                            "Trials whose level was chosen by a procedure from the responses, by "
                            "track and in order of presentation."),
                     true};
  ResultTable unsure{
      kUnsure,
      phrase("Analysis", "Responses “cannot tell”"),
      {kParticipant, kCondition, kUnsureColumn, kOf, kShare, interval_of(kShare)},
      phrase(
          "Analysis",
          "Proportion of the responses “cannot tell” among all responses, with Wilson’s 95 % CI. "
          "In psychometric functions, in proportions of hits and in the order effect such a "
          "response counts as the mean of a guess, that is, as 1/m of a choice of each of the m "
          "alternatives [Kaernbach 2001].")};
  ResultTable catch_trials{kCatchTrials,
                           phrase("Analysis", "Catch trials"),
                           {kParticipant, kBlock, kCatchTypeColumn, kCorrectCount, kOf, kShare},
                           note_on_catch_trials(gathered)};
  const bool has_types =
      std::any_of(gathered.catch_responses.begin(), gathered.catch_responses.end(),
                  [](const CatchResponses& each) { return each.type != CatchType::easy; });
  for (const CatchResponses& each : gathered.catch_responses) {
    catch_trials.add({each.participant, each.block,
                      has_types ? ResultCell{std::string(text_of(each.type))} : ResultCell{},
                      count_cell(each.correct), count_cell(each.trials),
                      static_cast<double>(each.correct) / static_cast<double>(each.trials)});
  }
  for (const DiscriminationResults& results : all) {
    add_mean_rows(results, means);
    add_track_rows(gathered, results, tracks);
    add_threshold_rows(gathered, results, thresholds);
    add_psychometric_rows(gathered, results, psychometric);
    add_order_rows(gathered, results, order);
    add_unsure_rows(gathered, results, unsure);
    add_place_rows(gathered, results, places);
  }
  catch_trials.drop_empty_columns(2);
  thresholds.drop_empty_columns(2);
  psychometric.drop_empty_columns(2);
  order.drop_empty_columns(1);
  places.drop_empty_columns(1);
  means.figures = threshold_figures;
  psychometric.figures = function_figures;
  tracks.figures = track_figures;
  if (!means.rows.empty()) outcome.tables.push_back(std::move(means));
  outcome.tables.push_back(std::move(thresholds));
  outcome.tables.push_back(std::move(psychometric));
  if (!tracks.rows.empty()) outcome.tables.push_back(std::move(tracks));
  if (!unsure.rows.empty()) outcome.tables.push_back(std::move(unsure));
  if (!order.rows.empty()) outcome.tables.push_back(std::move(order));
  if (!places.rows.empty()) outcome.tables.push_back(std::move(places));
  if (!catch_trials.rows.empty()) outcome.tables.push_back(std::move(catch_trials));
}

}  // namespace asperity
