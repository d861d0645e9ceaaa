// Collects choices by participant and task, fits them, and makes the columns of each threshold.

#include "app/exports/threshold_columns.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

namespace {

/// A threshold as columns: the end of its name, its quantity, and its description.
struct ThresholdOfWide {
  const char* ending = "";
  QuantityName quantity{};
  const char* description = "";
  bool has_unit = true;
};

std::vector<ThresholdOfWide> thresholds_of(const DiscriminationTask& task) {
  std::vector<ThresholdOfWide> all{};
  if (!task.is_performance) {
    all.push_back({"_pse", "pse", "point of subjective equality"});
  }
  if (task.design->has_noise()) {
    all.push_back(
        task.is_detection()
            ? ThresholdOfWide{"_threshold", "jnd.dprime1", "detection threshold at d′ = 1"}
            : ThresholdOfWide{"_jnd", "jnd.dprime1", "just-noticeable difference at d′ = 1"});
    if (!task.is_detection()) all.push_back({"_weber", "weber", "Weber fraction", false});
    return all;
  }
  if (task.design->is_choice_of_three()) {
    all.push_back(task.is_detection()
                      ? ThresholdOfWide{"_threshold", "jnd",
                                        "detection threshold at 66.7 % correct responses"}
                      : ThresholdOfWide{"_jnd", "jnd",
                                        "just-noticeable difference at 66.7 % correct responses"});
    if (!task.is_detection()) all.push_back({"_weber", "weber", "Weber fraction", false});
    return all;
  }
  if (task.is_detection()) {
    all.push_back({"_threshold", "jnd", "detection threshold at 75 % correct responses"});
    return all;
  }
  all.push_back({"_jnd", "jnd",
                 task.is_performance
                     ? "just-noticeable difference at 75 % correct responses"
                     : "just-noticeable difference, half the distance between 25 % and 75 %"});
  all.push_back({"_weber", "weber", "Weber fraction", false});
  return all;
}

std::string key_of_person(std::size_t person) { return std::to_string(person); }

/// Choices of the standard in place of those of the comparison.
HitsByValue of_standard(HitsByValue hits) {
  for (auto& [value, count] : hits) count.hits = count.trials - count.hits - count.unsure;
  return hits;
}

}  // namespace

std::int64_t ThresholdColumns::OfTask::Choices::unfinished_tracks() const {
  std::int64_t unfinished = 0;
  for (const auto& [place, trials] : in_unfinished_sessions) {
    std::vector<const DiscriminationTrial*> of_track{};
    for (const DiscriminationTrial& trial : trials) of_track.push_back(&trial);
    const PlacedTrials::Track track =
        placed_track(std::move(of_track), block->tracks, block->levels);
    unfinished += track.is_unfinished ? 1 : 0;
  }
  return unfinished;
}

void ThresholdColumns::add(std::size_t person, const StudyVocabulary::BlockOfDiscrimination& of,
                           const std::string& block, const Condition& condition,
                           const DiscriminationTrial& trial) {
  const DiscriminationTask& task = of.task;
  auto known = std::find_if(tasks_.begin(), tasks_.end(),
                            [&task](const OfTask& each) { return each.task == task; });
  if (known == tasks_.end()) known = tasks_.insert(tasks_.end(), OfTask{.task = task});
  Condition in_block{{"block", {0.0, block}}};
  in_block.insert(in_block.end(), condition.begin(), condition.end());
  OfTask::Choices& choices = known->choices[in_block][person];
  choices.by_procedure = choices.by_procedure || trial.by_procedure;
  if (trial.session_is_unfinished && trial.by_procedure && !of.tracks.empty()) {
    choices.block = &of;
    choices.in_unfinished_sessions[{trial.session, trial.block_ordinal, trial.track}].push_back(
        trial);
  }
  ChoiceCount& count = choices.of_comparison[trial.value];
  ++count.trials;
  count.hits += trial.chose_comparison ? 1 : 0;
  count.unsure += trial.is_unsure ? 1 : 0;
}

std::vector<ThresholdColumns::Column> ThresholdColumns::make(const std::string& name,
                                                             const std::string& of) const {
  std::vector<Column> columns{};
  for (const OfTask& each : tasks_) {
    const bool is_alone = tasks_.size() == 1;
    for (Column& column : make_task(each, is_alone ? name : name + '_' + each.task.name,
                                    is_alone ? of : of + ", block " + each.task.name)) {
      columns.push_back(std::move(column));
    }
  }
  return columns;
}

std::vector<ThresholdColumns::Column> ThresholdColumns::make_task(const OfTask& of_task,
                                                                  const std::string& name,
                                                                  const std::string& of) const {
  std::map<std::string, std::set<std::pair<double, std::string>>> levels{};
  std::vector<HitsByValue> all{};
  for (const auto& [condition, people] : of_task.choices) {
    for (const auto& [factor, level] : condition) levels[factor].insert(level);
    for (const auto& [person, choices] : people) all.push_back(choices.of_comparison);
  }
  const bool of_choices_of_standard = counts_standard(of_task.task, trend_of_choices(all));
  std::vector<Column> columns{};
  for (const auto& [condition, people] : of_task.choices) {
    std::string name_of_condition = name;
    std::string when{};
    for (const auto& [factor, level] : condition) {
      if (levels.at(factor).size() < 2) continue;
      name_of_condition += '_' + level.second;
      when += (when.empty() ? " where " : ", ") + factor + " = " + level.second;
    }
    std::vector<DiscriminationData> data{};
    Column unfinished{};
    unfinished.column = {.name = name_of_condition + "_unfinished_tracks",
                         .description =
                             "number of tracks that were begun and whose session ended before the "
                             "procedure stopped, "
                             "their threshold being estimated from the presented trials" +
                             of + when,
                         .type = "integer",
                         .unit = "1",
                         .minimum = 0.0};
    Column n{};
    n.column = {.name = name_of_condition + "_n",
                .description = "number of responses" + of + when,
                .type = "integer",
                .unit = "1",
                .minimum = 0.0};
    Column unsure{};
    bool has_unsure = false;
    unsure.column = {.name = name_of_condition + "_cannot_tell",
                     .description =
                         "number of responses \"cannot tell\", each of which counts as "
                         "the mean of a guess in the thresholds" +
                         of + when,
                     .type = "integer",
                     .unit = "1",
                     .minimum = 0.0};
    for (const auto& [person, choices] : people) {
      const HitsByValue& hits = choices.of_comparison;
      const ChoiceCount sum = sum_of_choices(hits);
      n.cells[person] = static_cast<std::int64_t>(sum.trials);
      unsure.cells[person] = static_cast<std::int64_t>(sum.unsure);
      has_unsure = has_unsure || sum.unsure > 0;
      if (const std::int64_t tracks = choices.unfinished_tracks(); tracks > 0) {
        unfinished.cells[person] = tracks;
      }
      data.push_back({.key = key_of_person(person),
                      .hits = of_choices_of_standard ? of_standard(hits) : hits,
                      .by_procedure = choices.by_procedure,
                      .needs_intervals = false});
    }
    const DiscriminationFit fit = fit_discrimination(of_task.task, data);
    const FoundNumbers found(fit.thresholds);
    for (const ThresholdOfWide& threshold : thresholds_of(of_task.task)) {
      Column made{};
      const std::string& unit = of_task.task.varied.unit;
      made.column = {.name = name_of_condition + threshold.ending,
                     .description = std::string(threshold.description) + " of the " +
                                    words_of_parameter(of_task.task.varied.parameter) + of + when,
                     .type = "number",
                     .unit = threshold.has_unit && !unit.empty() ? unit : "1",
                     .missing =
                         "no such response, or the threshold cannot be estimated within the "
                         "presented levels"};
      for (const auto& [person, hits] : people) {
        const std::optional<double> number = found.value(threshold.quantity, key_of_person(person));
        made.cells[person] = number ? Cell{*number} : Cell{};
      }
      columns.push_back(std::move(made));
    }
    columns.push_back(std::move(n));
    if (has_unsure) columns.push_back(std::move(unsure));
    if (!unfinished.cells.empty()) columns.push_back(std::move(unfinished));
  }
  return columns;
}

}  // namespace asperity
