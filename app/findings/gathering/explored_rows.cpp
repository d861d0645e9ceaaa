// Finds the factors in passes over the rows; a factor needs 2 to 24 levels, and no items that repeat a condition.

#include "app/findings/gathering/explored_rows.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "app/findings/gathering/trial_factors.h"

namespace asperity {

namespace {

constexpr std::size_t kMostLevelsOfFactor = 24;

/// Names in tables, which a factor of a protocol cannot have as well.
constexpr const char* kBlockColumn = "block";
constexpr const char* kSurfaceColumn = "surface";

bool is_reserved(const std::string& name) {
  static const std::set<std::string> kReserved{"subject", "value",         "y",
                                               "block",   "surface",       "trial_place",
                                               "column",  "session_place", "block_place"};
  return kReserved.contains(name);
}

std::string shown_name(ExploredBy by, const std::string& of_trials) {
  switch (by) {
    case ExploredBy::everything:
      break;
    case ExploredBy::trial:
      return of_trials != kColumnFactor && is_reserved(of_trials) ? of_trials + "_factor"
                                                                  : of_trials;
    case ExploredBy::block:
      return kBlockColumn;
    case ExploredBy::item:
      return kSurfaceColumn;
  }
  return {};
}

}  // namespace

ExploredFactor::ExploredFactor(const GatheredAnswers& gathered, ExploredBy by,
                               std::string of_trials)
    : name(shown_name(by, of_trials)),
      is_condition(of_trials != kColumnFactor),
      gathered_(gathered),
      by_(by),
      of_trials_(std::move(of_trials)) {
  if (by_ != ExploredBy::trial) return;
  for (const auto& levels_of_trial : gathered.factor_levels) {
    const auto level = levels_of_trial.find(of_trials_);
    by_combination_.push_back(level == levels_of_trial.end() ? kNoWord : level->second);
  }
  for (std::uint32_t word = 0; word < gathered.words.size(); ++word) {
    is_left_out_.push_back(is_chosen_or_drawn(gathered, word, of_trials_));
  }
}

std::uint32_t ExploredFactor::word_of_level(const ExploredRow& row) const {
  switch (by_) {
    case ExploredBy::everything:
      break;
    case ExploredBy::trial:
      return is_left_out_[row.answer.block] ? kNoWord : by_combination_[row.answer.factors];
    case ExploredBy::block:
      return row.answer.block;
    case ExploredBy::item:
      return gathered_.surfaces[row.surface].item;
  }
  return kNoWord;
}

void ExploredFactor::set_levels(const std::vector<bool>& words) {
  for (std::uint32_t word = 0; word < words.size(); ++word) {
    if (words[word]) levels.push_back(gathered_.word(word));
  }
  if (levels.size() > kMostLevelsOfFactor) return;
  sort_levels(levels);
  code_of_word_.assign(words.size(), LabelColumn::kMissing);
  for (const std::string& level : levels) {
    words_.push_back(*gathered_.words.find(level));
    code_of_word_[words_.back()] = words_.size() - 1;
  }
}

ExploredRows::ExploredRows(const GatheredAnswers& gathered, ExploredUnit unit)
    : gathered_(gathered), unit_(unit) {
  std::optional<std::uint32_t> last{};
  for_each([&](const ExploredRow& row) {
    ++size_;
    if (last != row.answer.person) ++participants_;
    last = row.answer.person;
  });
  add_factor({gathered, ExploredBy::trial, std::string(kColumnFactor)});
  add_factors_of_trials();
  add_factor({gathered, ExploredBy::block});
  add_items();
}

void ExploredRows::for_each(const std::function<void(const ExploredRow&)>& visit) const {
  for (const GatheredAnswer& answer : gathered_.answers) {
    if (answer.continues_trial) continue;
    const std::size_t rows = unit_ == ExploredUnit::trial ? 1 : answer.surface_count;
    for (std::size_t i = 0; i < rows; ++i) visit({answer, answer.first_surface + i});
  }
}

void ExploredRows::add_factor(ExploredFactor factor) {
  std::vector<bool> words(gathered_.words.size());
  for_each([&](const ExploredRow& row) {
    const std::uint32_t word = factor.word_of_level(row);
    if (word == kNoWord) {
      factor.is_complete = false;
    } else {
      words[word] = true;
    }
  });
  factor.set_levels(words);
  const std::size_t levels = factor.levels.size();
  if (levels < 2 || levels > kMostLevelsOfFactor) return;
  factors_.push_back(std::move(factor));
}

void ExploredRows::add_factors_of_trials() {
  std::set<std::string> names{};
  for (const auto& levels : gathered_.factor_levels) {
    for (const auto& [name, level] : levels) names.insert(name);
  }
  names.erase(std::string(kColumnFactor));
  for (const std::string& name : names) add_factor({gathered_, ExploredBy::trial, name});
}

void ExploredRows::add_items() {
  bool have_one_surface = true;
  for_each([&](const ExploredRow& row) {
    have_one_surface =
        have_one_surface && (unit_ == ExploredUnit::surface || row.answer.surface_count == 1);
  });
  if (!have_one_surface) return;
  const std::size_t before = factors_.size();
  add_factor({gathered_, ExploredBy::item});
  if (factors_.size() > before && is_one_with_a_condition(factors_.back())) factors_.pop_back();
}

/// Whether a factor divides the rows into the same groups.
bool ExploredRows::is_one_with_a_condition(const ExploredFactor& items) const {
  const auto is_one = [&](const ExploredFactor& factor) {
    if (factor.levels.size() != items.levels.size()) return false;
    bool are_same = true;
    std::vector<std::optional<std::size_t>> item_of(factor.levels.size() + 1);
    for_each([&](const ExploredRow& row) {
      const std::size_t level = factor.level(row);
      std::optional<std::size_t>& item =
          item_of[level == LabelColumn::kMissing ? factor.levels.size() : level];
      if (!item) item = items.level(row);
      are_same = are_same && *item == items.level(row);
    });
    return are_same;
  };
  return std::any_of(factors_.begin(), factors_.end() - 1, [&](const ExploredFactor& factor) {
    return factor.is_condition && is_one(factor);
  });
}

}  // namespace asperity
