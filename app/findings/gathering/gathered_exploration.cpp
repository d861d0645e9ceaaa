// Averages by condition at the end of each participant; of single surfaces it keeps contact time, force and speed.

#include "app/findings/gathering/gathered_exploration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/findings/gathering/gathered_answers.h"
#include "protocols/design/block_factors.h"

namespace asperity {

namespace {

using MeasuredQuantity = std::optional<double> SessionAnswers::Exploration::*;

/// Null for the response time.
MeasuredQuantity measured_quantity(Explored quantity) noexcept {
  using Surface = SessionAnswers::Exploration;
  switch (quantity) {
    case Explored::contact_s:
      return &Surface::contact_s;
    case Explored::visits:
      return &Surface::visits;
    case Explored::path_m:
      return &Surface::path_m;
    case Explored::strokes:
      return &Surface::strokes;
    case Explored::stroke_length_m:
      return &Surface::stroke_length_m;
    case Explored::response_s:
      return nullptr;
    case Explored::force_N:
      return &Surface::force_N;
    case Explored::force_sd_N:
      return &Surface::force_sd_N;
    case Explored::speed_m_per_s:
      return &Surface::speed_m_per_s;
    case Explored::speed_sd_m_per_s:
      return &Surface::speed_sd_m_per_s;
  }
  return nullptr;
}

/// What one participant explored in one condition.
struct OwnExplorations {
  std::vector<const SessionAnswers::Exploration*> surfaces{};
  std::vector<double> response_s{};
};

/// The explorations of one participant by condition.
class OwnConditions final {
 public:
  explicit OwnConditions(const GatheredAnswers& gathered) : gathered_(gathered) {}

  /// The first answer of a trial, with the explorations of its surfaces.
  void add(const GatheredAnswer& answer, std::span<const SessionAnswers::Exploration> explored) {
    const auto surfaces = gathered_.surfaces_of(answer);
    for (const ExploredCondition& condition : conditions_of_trial(answer)) {
      OwnExplorations& own = by_condition_[condition];
      for (const SessionAnswers::Exploration& one : explored) own.surfaces.push_back(&one);
      if (answer.response_time_s) own.response_s.push_back(*answer.response_time_s);
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i].item == kNoWord) continue;
      OwnExplorations& own = by_condition_[{.by = ExploredBy::item, .level = surfaces[i].item}];
      own.surfaces.push_back(&explored[i]);
      if (surfaces.size() == 1 && answer.response_time_s) {
        own.response_s.push_back(*answer.response_time_s);
      }
    }
  }
  const std::map<ExploredCondition, OwnExplorations>& by_condition() const noexcept {
    return by_condition_;
  }

 private:
  std::vector<ExploredCondition> conditions_of_trial(const GatheredAnswer& answer) const {
    std::vector<ExploredCondition> conditions{{.by = ExploredBy::everything}};
    if (answer.block != kNoWord) {
      conditions.push_back({.by = ExploredBy::block, .level = answer.block});
    }
    for (const auto& [factor, level] : gathered_.factor_levels[answer.factors]) {
      if (level == kNoWord || is_chosen_or_drawn(gathered_, answer.block, factor)) continue;
      conditions.push_back({.by = ExploredBy::trial, .factor = factor, .level = level});
    }
    return conditions;
  }

  const GatheredAnswers& gathered_;
  std::map<ExploredCondition, OwnExplorations> by_condition_{};
};

/// Nothing where NaN stands for none, and where the exploration was not read.
template <typename Number>
std::optional<double> number_at(const std::vector<Number>& numbers, std::size_t surface) {
  if (surface >= numbers.size() || std::isnan(numbers[surface])) return std::nullopt;
  return static_cast<double>(numbers[surface]);
}

}  // namespace

OwnAverage own_average_of(Explored quantity) noexcept {
  return quantity == Explored::contact_s || quantity == Explored::response_s ? OwnAverage::median
                                                                             : OwnAverage::mean;
}

bool is_chosen_or_drawn(const GatheredAnswers& gathered, std::uint32_t block,
                        const std::string& factor) {
  if (factor == kColumnFactor) return false;
  const auto found = gathered.blocks.find(gathered.word(block));
  if (found == gathered.blocks.end()) return false;
  const Protocol::Block& asked = found->second;
  return std::find(asked.drawn.begin(), asked.drawn.end(), factor) != asked.drawn.end() ||
         (chooses_levels_from_answers(asked) && asked.vary && asked.vary->factor == factor);
}

void GatheredExploration::add(std::span<const SessionAnswers::Exploration> surfaces) {
  for (const SessionAnswers::Exploration& one : surfaces) {
    has_contact_time_ = has_contact_time_ || one.contact_s.has_value();
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    contact_s_.push_back(one.contact_s.value_or(kNone));
    force_N_.push_back(static_cast<float>(one.force_N.value_or(kNone)));
    speed_m_per_s_.push_back(static_cast<float>(one.speed_m_per_s.value_or(kNone)));
    of_participant_.push_back(one);
  }
}

void GatheredExploration::end_participant(const GatheredAnswers& gathered) {
  if (ended_answers_ == gathered.answers.size()) return;
  const std::size_t person = gathered.answers.back().person;
  const std::size_t first_surface = contact_s_.size() - of_participant_.size();
  if (of_participant_.empty() && first_surface < gathered.surfaces.size()) {
    ended_answers_ = gathered.answers.size();  // the exploration was not read
    return;
  }
  OwnConditions conditions(gathered);
  for (; ended_answers_ < gathered.answers.size(); ++ended_answers_) {
    const GatheredAnswer& answer = gathered.answers[ended_answers_];
    if (answer.continues_trial) continue;
    conditions.add(answer,
                   std::span(of_participant_)
                       .subspan(answer.first_surface - first_surface, answer.surface_count));
  }
  std::vector<double> values{};
  for (const auto& [condition, explored] : conditions.by_condition()) {
    OwnValues& own = own_[condition];
    for (std::size_t i = 0; i < kExploredQuantityCount; ++i) {
      const auto quantity = static_cast<Explored>(i);
      values.clear();
      if (const MeasuredQuantity of = measured_quantity(quantity)) {
        for (const SessionAnswers::Exploration* surface : explored.surfaces) {
          if (surface->*of) values.push_back(*(surface->*of));
        }
      } else {
        values = explored.response_s;
      }
      if (values.empty()) continue;
      const std::size_t measurements = values.size();
      own[i].push_back({.participant = person,
                        .measurements = measurements,
                        .value = own_average(own_average_of(quantity), values)});
    }
  }
  of_participant_.clear();
}

std::optional<double> GatheredExploration::contact_s(std::size_t surface) const {
  return number_at(contact_s_, surface);
}

std::optional<double> GatheredExploration::force_N(std::size_t surface) const {
  return number_at(force_N_, surface);
}

std::optional<double> GatheredExploration::speed_m_per_s(std::size_t surface) const {
  return number_at(speed_m_per_s_, surface);
}

std::span<const OwnValue> GatheredExploration::own_values(const ExploredCondition& condition,
                                                          Explored quantity) const {
  const auto found = own_.find(condition);
  if (found == own_.end()) return {};
  return found->second[static_cast<std::size_t>(quantity)];
}

}  // namespace asperity
