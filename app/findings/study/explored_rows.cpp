#include "app/findings/study/explored_rows.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "app/findings/study/answer_columns.h"

namespace asperity {

namespace {

constexpr std::size_t kMostLevelsOfFactor = 24;

/// Columns of the tidy tables, which a factor of a protocol cannot be named as well.
constexpr const char* kBlockColumn = "block";
constexpr const char* kSurfaceColumn = "surface";

bool is_reserved(const std::string& name) {
  static const std::set<std::string> kReserved{"subject", "value",         "y",
                                               "block",   "surface",       "trial_place",
                                               "column",  "session_place", "block_place"};
  return kReserved.contains(name);
}

/// Whether the levels of a factor are not conditions: a procedure chose them, or they were drawn for every trial.
bool is_no_condition(const GatheredAnswers& gathered, const GatheredAnswer& answer,
                     const std::string& factor) {
  const auto block = gathered.blocks.find(gathered.word(answer.block));
  if (block == gathered.blocks.end()) return false;
  const std::vector<std::string>& drawn = block->second.drawn;
  if (std::find(drawn.begin(), drawn.end(), factor) != drawn.end()) return true;
  return block->second.has_procedure && block->second.vary && block->second.vary->factor == factor;
}

}  // namespace

ExploredRows::ExploredRows(const GatheredAnswers& gathered, ExploredUnit unit)
    : gathered_(gathered) {
  for (const GatheredAnswer& answer : gathered.answers) {
    if (answer.continues_trial) continue;
    switch (unit) {
      case ExploredUnit::trial:
        places_.push_back({&answer, answer.first_surface});
        break;
      case ExploredUnit::surface:
        for (std::size_t i = 0; i < answer.surface_count; ++i) {
          places_.push_back({&answer, answer.first_surface + i});
        }
        break;
    }
  }
  add_factor(
      std::string(kColumnFactor),
      [&gathered](const Place& place) { return gathered.word(gathered.column_of(*place.answer)); },
      false);
  add_factors_of_trials();
  add_factor(kBlockColumn,
             [&gathered](const Place& place) { return gathered.word(place.answer->block); });
  add_items(unit);
}

template <typename Of>
NumberColumn ExploredRows::column(const Of& of) const {
  NumberColumn numbers{};
  numbers.reserve(places_.size());
  for (const Place& place : places_) numbers.emplace_back(of(place));
  return numbers;
}

template <typename Of>
void ExploredRows::add_factor(const std::string& name, const Of& level_of, bool is_condition) {
  std::vector<std::string> by_row{};
  by_row.reserve(places_.size());
  for (const Place& place : places_) by_row.push_back(level_of(place));
  TrialFactor factor = trial_factor(name, by_row);
  const std::size_t levels = factor.levels.names.size();
  if (levels < 2 || levels > kMostLevelsOfFactor) return;
  factors_.push_back({.factor = std::move(factor), .is_condition = is_condition});
}

void ExploredRows::add_factors_of_trials() {
  std::set<std::string> names{};
  for (const auto& levels : gathered_.factor_levels) {
    for (const auto& [name, level] : levels) names.insert(name);
  }
  names.erase(std::string(kColumnFactor));
  for (const std::string& name : names) {
    add_factor(is_reserved(name) ? name + "_factor" : name, [&](const Place& place) {
      return is_no_condition(gathered_, *place.answer, name)
                 ? std::string()
                 : gathered_.word(gathered_.level(*place.answer, name));
    });
  }
}

void ExploredRows::add_items(ExploredUnit unit) {
  const bool have_one_surface = unit == ExploredUnit::surface ||
                                std::all_of(places_.begin(), places_.end(), [](const Place& place) {
                                  return place.answer->surface_count == 1;
                                });
  if (!have_one_surface) return;
  const std::size_t before = factors_.size();
  add_factor(kSurfaceColumn, [this](const Place& place) {
    return gathered_.word(gathered_.surfaces[place.surface].item);
  });
  if (factors_.size() == before) return;
  const bool is_known =
      std::any_of(factors_.begin(), factors_.end() - 1, [this](const ExploredFactor& known) {
        return known.is_condition && are_same_groups(known.factor, factors_.back().factor);
      });
  if (is_known) factors_.pop_back();
}

LabelColumn ExploredRows::people() const {
  LabelColumn people = labels_of_people(gathered_);
  people.codes.reserve(places_.size());
  for (const Place& place : places_) people.codes.push_back(place.answer->person);
  return people;
}

NumberColumn ExploredRows::quantity(std::optional<double> SessionAnswers::Exploration::*of) const {
  return column([&](const Place& place) { return gathered_.explorations[place.surface].*of; });
}

NumberColumn ExploredRows::response_times() const {
  return column([](const Place& place) { return place.answer->response_time_s; });
}

NumberColumn ExploredRows::trial_places() const {
  return column([](const Place& place) {
    return static_cast<double>(place.answer->trial_of_block - 1) / kTrialsPerPlace;
  });
}

NumberColumn ExploredRows::block_places() const {
  return column(
      [](const Place& place) { return static_cast<double>(place.answer->block_ordinal); });
}

NumberColumn ExploredRows::session_places() const {
  return column([](const Place& place) { return static_cast<double>(place.answer->session); });
}

}  // namespace asperity
