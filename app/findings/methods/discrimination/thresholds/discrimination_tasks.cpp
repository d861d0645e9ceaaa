// Joins blocks of equal tasks, names conditions by the factors that vary, and finds the direction of the question.

#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "app/findings/outcome/cell_words.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr std::string_view kComparisonRole = "comparison";
double half_unsure(const ChoiceCount& count) { return split_hits(count, 2); }

constexpr const char* kNothingVaries = "all";
constexpr double kClearTrend = 1.96;  // two-sided, α = .05

/// The block of a trial, as a word, and its levels by factor: without that of the parameter, and without those that are drawn
/// for every trial, which would divide the trials into small groups.
struct ConditionOfTrial {
  std::uint32_t block = kNoWord;
  std::map<std::string, std::uint32_t, std::less<>> levels{};
};

ConditionOfTrial condition_of(const GatheredAnswers& gathered, const GatheredAnswer& answer,
                              const std::string& varied) {
  ConditionOfTrial condition{.block = answer.block,
                             .levels = gathered.factor_levels[answer.factors]};
  condition.levels.erase(varied);
  const auto block = gathered.blocks.find(gathered.word(answer.block));
  if (block == gathered.blocks.end()) return condition;
  for (const std::string& factor : block->second.drawn) condition.levels.erase(factor);
  return condition;
}

/// Names the conditions of a task by the blocks, if there are several, and the levels of the factors that have several.
/// The name of the factor precedes a number, which would have no meaning without it.
class ConditionNames final {
 public:
  void add(const ConditionOfTrial& condition) {
    blocks_.insert(condition.block);
    for (const auto& [factor, level] : condition.levels) of_factor_[factor].insert(level);
  }
  std::string name(const GatheredAnswers& gathered, const ConditionOfTrial& condition) const {
    std::string name = blocks_.size() > 1 ? gathered.word(condition.block) : std::string();
    for (const auto& [factor, level] : condition.levels) {
      if (of_factor_.at(factor).size() < 2) continue;
      const std::string& word = gathered.word(level);
      name += (name.empty() ? "" : ", ") + (number_in(word) ? factor + ' ' + word : word);
    }
    return name.empty() ? kNothingVaries : name;
  }

 private:
  std::set<std::uint32_t> blocks_{};
  std::map<std::string, std::set<std::uint32_t>> of_factor_{};
};

/// The conditions by their words: numbers by value and before other words.
bool is_before(const std::string& one, const std::string& other) {
  const std::vector<std::string> words = parts_of(one, ' ');
  const std::vector<std::string> others = parts_of(other, ' ');
  for (std::size_t i = 0; i < std::min(words.size(), others.size()); ++i) {
    const auto number_of_word = [](std::string word) {
      if (word.ends_with(',')) word.pop_back();
      return number_in(word);
    };
    const std::optional<double> first = number_of_word(words[i]);
    const std::optional<double> second = number_of_word(others[i]);
    if (first.has_value() != second.has_value()) return first.has_value();
    if (first && *first != *second) return *first < *second;
    if (!first && words[i] != others[i]) return words[i] < others[i];
  }
  return words.size() != others.size() ? words.size() < others.size() : one < other;
}

DiscriminationStudy study_of(const GatheredAnswers& gathered, const DiscriminationTask& task,
                             const std::set<std::string, std::less<>>& blocks) {
  DiscriminationStudy study{.task = task};
  std::vector<const GatheredAnswer*> answers{};
  ConditionNames names{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!blocks.contains(gathered.word(answer.block))) continue;
    const auto surfaces = gathered.surfaces_of(answer);
    const std::string& level = gathered.word(gathered.level(answer, task.varied.factor));
    if (surfaces.size() != task.design->surfaces() || !number_in(level)) {
      ++study.left_out;
      continue;
    }
    answers.push_back(&answer);
    names.add(condition_of(gathered, answer, task.varied.factor));
  }
  std::vector<std::string> conditions{};
  for (const GatheredAnswer* const answer : answers) {
    conditions.push_back(names.name(gathered, condition_of(gathered, *answer, task.varied.factor)));
  }
  const std::set<std::string> distinct(conditions.begin(), conditions.end());
  study.conditions.assign(distinct.begin(), distinct.end());
  std::sort(study.conditions.begin(), study.conditions.end(), is_before);
  for (const std::string& condition : study.conditions) {
    const auto first = std::find(conditions.begin(), conditions.end(), condition);
    ConditionOfTrial in_group =
        condition_of(gathered, *answers[static_cast<std::size_t>(first - conditions.begin())],
                     task.varied.factor);
    in_group.levels.erase(gathered.group_factor);
    const std::string name = names.name(gathered, in_group);
    study.conditions_in_group.push_back(name == kNothingVaries ? "" : name);
  }
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const GatheredAnswer& answer = *answers[i];
    const auto place = std::find(study.conditions.begin(), study.conditions.end(), conditions[i]);
    const auto surfaces = gathered.surfaces_of(answer);
    const auto comparisons = static_cast<std::size_t>(
        std::count_if(surfaces.begin(), surfaces.end(), [&gathered](const FeltSurface& surface) {
          return gathered.word(surface.item).starts_with(kComparisonRole);
        }));
    const bool is_signal = !task.design->has_noise() || task.design->is_signal(comparisons);
    const double level = *number_in(gathered.word(gathered.level(answer, task.varied.factor)));
    const auto place_of = [&](const std::string& item) {
      const auto found = std::find_if(
          surfaces.begin(), surfaces.end(),
          [&](const FeltSurface& surface) { return gathered.word(surface.item) == item; });
      return found == surfaces.end() ? 0U : static_cast<std::size_t>(found - surfaces.begin());
    };
    study.trials.push_back(
        {.person = answer.person,
         .condition = static_cast<std::size_t>(place - study.conditions.begin()),
         .value = is_signal ? level : task.standard(),
         .comparisons = comparisons,
         .is_signal = is_signal,
         .chose_comparison =
             is_hit_response(task, comparisons, gathered.word(gathered.reply_of(answer).answer)),
         .is_unsure = gathered.word(gathered.reply_of(answer).answer) == kCannotTell,
         .comparison_first = gathered.word(surfaces[0].item) == kComparisonRole,
         .correct_place = place_of(std::string(task.design->correct_response(comparisons))),
         .chosen_place = place_of(gathered.word(gathered.reply_of(answer).answer)),
         .confidence = answer.confidence,
         .block = answer.block,
         .by_procedure = answer.track != 0 && chooses_levels_from_answers(
                                                  gathered.blocks.at(gathered.word(answer.block))),
         .session = answer.session,
         .block_ordinal = answer.block_ordinal,
         .track = answer.track,
         .step = answer.step,
         .session_is_unfinished = answer.session_is_unfinished,
         .first_surface = answer.first_surface});
  }
  HitsByValue choices{};
  for (const DiscriminationTrial& trial : study.trials) {
    study.count(trial, choices[trial.value]);  // counts_standard is not set yet
  }
  const double trend = trend_of_choices({&choices, 1});
  study.counts_standard = counts_standard(task, trend);
  study.is_direction_uncertain =
      !task.is_performance && !task.asks_for && std::abs(trend) < kClearTrend;
  return study;
}

}  // namespace

double split_hits(const ChoiceCount& count, std::size_t alternatives) {
  const auto hits = static_cast<double>(count.hits);
  if (count.unsure == 0) return hits;
  return hits + static_cast<double>(count.unsure) / static_cast<double>(alternatives);
}

double split_proportion(const ChoiceCount& count, std::size_t alternatives) {
  return split_hits(count, alternatives) / static_cast<double>(count.trials);
}

ChoiceCount sum_of_choices(const std::map<double, ChoiceCount>& by_value) {
  ChoiceCount sum{};
  for (const auto& [value, count] : by_value) {
    sum.hits += count.hits;
    sum.trials += count.trials;
    sum.unsure += count.unsure;
  }
  return sum;
}

bool DiscriminationStudy::has_unsure() const {
  return std::any_of(trials.begin(), trials.end(),
                     [](const DiscriminationTrial& trial) { return trial.is_unsure; });
}

void DiscriminationStudy::count(const DiscriminationTrial& trial, ChoiceCount& count) const {
  ++count.trials;
  count.hits += is_hit(trial) ? 1 : 0;
  count.unsure += trial.is_unsure ? 1 : 0;
}

double trend_of_choices(std::span<const HitsByValue> all) {
  double trials = 0.0;
  double values = 0.0;
  double hits = 0.0;
  for (const HitsByValue& each : all) {
    for (const auto& [value, count] : each) {
      trials += static_cast<double>(count.trials);
      values += value * static_cast<double>(count.trials);
      hits += half_unsure(count);
    }
  }
  double products = 0.0;
  double squares = 0.0;
  for (const HitsByValue& each : all) {
    for (const auto& [value, count] : each) {
      const double deviation = value - values / trials;
      const auto of_value = static_cast<double>(count.trials);
      products += deviation * (half_unsure(count) - of_value * hits / trials);
      squares += of_value * deviation * deviation;
    }
  }
  const double squares_of_hits = hits * (trials - hits) / trials;
  if (trials < 2.0 || squares <= 0.0 || squares_of_hits <= 0.0) return 0.0;
  return products / std::sqrt(squares * squares_of_hits / (trials - 1.0));
}

bool DiscriminationTask::operator==(const DiscriminationTask& other) const {
  const auto parts = [](const DiscriminationTask& task) {
    return std::tie(task.design, task.is_performance, task.is_sequential, task.asks_for,
                    task.question, task.prompt, task.varied.factor, task.varied.parameter,
                    task.varied.standard);
  };
  return parts(*this) == parts(other);
}

std::optional<DiscriminationTask> discrimination_task(const std::string& block_name,
                                                      const Protocol::Block& block) {
  if (!block.vary || !block.vary->standard) return std::nullopt;
  const Protocol::TrialQuestionTemplate* const asked = judged_question(block);
  if (asked == nullptr || block.design() == nullptr) return std::nullopt;
  DiscriminationTask task{
      .name = block_name,
      .question = asked->name,
      .prompt = asked->prompt,
      .design = block.design(),
      .is_performance = asked->judgement() == DiscriminationJudgement::performance,
      .is_sequential = block.arrangement.surfaces == Arrangement::Surfaces::sequential,
      .asks_for = asked->own_as<DiscriminationQuestion>()->asks_for,
      .varied = *block.vary,
      .has_levels_of_procedure = chooses_levels_from_answers(block)};
  task.varied.unit = unit_of_parameter(task.varied.parameter);
  return task;
}

bool is_hit_response(const DiscriminationTask& task, std::size_t comparisons,
                     const std::string& answer) {
  return answer ==
         (task.design->has_noise() ? task.design->yes : task.design->correct_response(comparisons));
}

bool counts_standard(const DiscriminationTask& task, double trend) {
  return !task.is_performance &&
         (task.asks_for ? task.asks_for == DiscriminationQuestion::AsksFor::less : trend < 0.0);
}

std::vector<DiscriminationStudy> discrimination_studies(const GatheredAnswers& gathered) {
  struct BlocksOfTask {
    DiscriminationTask task{};
    std::set<std::string, std::less<>> blocks{};
    bool has_procedure = false;
  };
  std::vector<BlocksOfTask> tasks{};
  for (const auto& [name, block] : gathered.blocks) {
    const std::optional<DiscriminationTask> task = discrimination_task(name, block);
    if (!task) continue;
    auto known = std::find_if(tasks.begin(), tasks.end(),
                              [&task](const auto& each) { return each.task == *task; });
    if (known == tasks.end()) known = tasks.insert(tasks.end(), BlocksOfTask{.task = *task});
    known->blocks.insert(name);
    known->has_procedure = known->has_procedure || chooses_levels_from_answers(block);
  }
  std::vector<DiscriminationStudy> studies{};
  for (const BlocksOfTask& each : tasks) {
    DiscriminationStudy study = study_of(gathered, each.task, each.blocks);
    study.has_levels_of_procedure = each.has_procedure;
    if (!study.trials.empty()) studies.push_back(std::move(study));
  }
  return studies;
}

}  // namespace asperity
