// Implements the estimate of a session's duration.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "protocols/design/block_factors.h"
#include "protocols/plan/plan.h"

namespace asperity {

namespace {

// Assumptions of `check` about durations that a protocol does not specify.
constexpr double kReadingWords_per_s = 3.0;
constexpr double kShortestReading_s = 5.0;
constexpr double kCheck_s = 15.0;
constexpr double kQuestion_s = 8.0;
constexpr double kChoice_s = 4.0;
constexpr double kFeedback_s = 2.0;

double reading_s(const std::string& text) {
  const auto words = 1 + std::count(text.begin(), text.end(), ' ');
  return std::max(kShortestReading_s, static_cast<double>(words) / kReadingWords_per_s);
}

/// The duration of the target strokes, within the limits on contact; without strokes the minimum contact.
double contact_s(const Exploration& exploration) {
  const auto aim = [](const Band& band) {
    return band.target ? band.target : band.minimum ? band.minimum : band.maximum;
  };
  const auto strokes = aim(exploration.strokes);
  const auto length_m = aim(exploration.stroke_length_m);
  const auto speed_m_per_s = aim(exploration.speed_m_per_s);
  const double least_s = exploration.minimum_contact_s;
  if (!strokes || !length_m || !speed_m_per_s || *speed_m_per_s <= 0.0) return least_s;
  return std::clamp(*strokes * *length_m / *speed_m_per_s, least_s, exploration.maximum_contact_s);
}

/// The end of a visit that the arrangement states, or else what the exploration requests.
double contact_of_visit_s(const Exploration& exploration, const Arrangement& arrangement) {
  if (arrangement.contact_s) return *arrangement.contact_s;
  if (!arrangement.strokes) return contact_s(exploration);
  Exploration with_strokes = exploration;
  with_strokes.strokes.target = *arrangement.strokes;
  return contact_s(with_strokes);
}

/// What the exploration requests of a patch, or the required visits if they take longer.
double contact_of_patch_s(const Exploration& exploration, const Trial& trial) {
  constexpr double kSpeed_m_per_s = 0.08;  // of a hand that is not instructed
  const SurfacePatch& patch = trial.presentations.front().patch;
  const double width_m =
      trial.arrangement.axis == Arrangement::Axis::x ? patch.extent_m.x : patch.extent_m.y;
  const Band& speed = exploration.speed_m_per_s;
  const double crossing_s = width_m / speed.target.value_or(kSpeed_m_per_s);
  return std::max(contact_s(exploration), trial.arrangement.minimum_visits * crossing_s);
}

/// The requests of a drift check are read and confirmed, then each part is recorded.
double drift_check_s(const Protocol::Break& pause) {
  if (!pause.drift_check) return 0.0;
  const Protocol::Break::DriftCheck& check = *pause.drift_check;
  const double of_tip_s =
      check.tip_text.empty() ? 0.0 : reading_s(check.tip_text) + check.duration_s;
  return reading_s(check.text) + check.duration_s + of_tip_s;
}

/// Adds steps to a cost, in order.
class CostSum final {
 public:
  CostSum(const Protocol& protocol, const Plan& plan) : protocol_(protocol), plan_(plan) {}

  const PlanCost& cost() const noexcept { return cost_; }

  void add(const PlanStep& step) {
    if (const auto* const screen = std::get_if<Protocol::Screen>(&step)) {
      spend(reading_s(screen->text));
    } else if (std::holds_alternative<Protocol::Check>(step)) {
      spend(kCheck_s);
    } else if (const auto* const ask = std::get_if<Protocol::Ask>(&step)) {
      spend(kQuestion_s * static_cast<double>(ask->questions.size()));
    } else if (const auto* const pause = std::get_if<Protocol::Break>(&step)) {
      rest(*pause);
    } else {
      add(plan_.trials[std::get<TrialStep>(step).trial]);
    }
  }

 private:
  void rest(const Protocol::Break& pause) {
    cost_.total_s += pause.minimum_s + drift_check_s(pause);
    since_break_s_ = 0.0;
    contact_since_break_s_ = 0.0;
  }

  /// The breaks that the plan does not contain: between two trials of a block.
  void rest_after_contact(const Protocol::Block& block, int block_ordinal) {
    const bool is_within_block = std::exchange(block_ordinal_, block_ordinal) == block_ordinal;
    if (!is_within_block) return;
    for (const Protocol::Run* const run : runs_of(protocol_, block)) {
      const double limit_s = run->break_every_contact_s;
      if (limit_s <= 0.0 || contact_since_break_s_ < limit_s) continue;
      cost_.breaks_after_contact_s += run->pause->minimum_s + drift_check_s(*run->pause);
      return rest(*run->pause);
    }
  }

  void add(const Trial& trial) {
    const Protocol::Block& block = protocol_.blocks.at(trial.block);
    rest_after_contact(block, trial.block_ordinal);
    const auto surfaces = static_cast<double>(trial.presentations.size());
    const Arrangement& arrangement = trial.arrangement;
    const Exploration& exploration = exploration_of(protocol_, trial);
    const double visits = surfaces * arrangement.minimum_visits;
    // Side by side the exploration applies to each patch, however often it is visited.
    const bool is_shared = arrangement.surfaces == Arrangement::Surfaces::side_by_side;
    const double felt_s = is_shared ? surfaces * contact_of_patch_s(exploration, trial)
                                    : visits * contact_of_visit_s(exploration, arrangement);
    ++cost_.trials;
    cost_.contacts += static_cast<int>(visits);
    cost_.contact_s += felt_s;
    contact_since_break_s_ += felt_s;
    double answers = 0.0;
    for (const Question& question : trial.questions) {
      answers += items_of(question.form, static_cast<int>(trial.presentations.size()));
    }
    const double pause_s =
        arrangement.interval
            ? 0.5 * (arrangement.interval->shortest_s + arrangement.interval->longest_s)
            : block.pause_between_surfaces_s;
    spend(felt_s + block.pause_before_trial_s + (is_shared ? 0.0 : (visits - 1.0) * pause_s) +
          kChoice_s * answers +
          (block.feedback == Protocol::Block::Feedback::none ? 0.0 : kFeedback_s));
  }

  void spend(double time_s) {
    cost_.total_s += time_s;
    since_break_s_ += time_s;
    cost_.longest_without_break_s = std::max(cost_.longest_without_break_s, since_break_s_);
  }

  const Protocol& protocol_;
  const Plan& plan_;
  PlanCost cost_{};
  double since_break_s_ = 0.0;
  double contact_since_break_s_ = 0.0;
  int block_ordinal_ = 0;  // of the last trial
};

}  // namespace

PlanCost cost_of(const Protocol& protocol, const Plan& plan) {
  return cost_from(protocol, plan, 0);
}

PlanCost cost_from(const Protocol& protocol, const Plan& plan, std::size_t first) {
  CostSum sum(protocol, plan);
  for (std::size_t i = first; i < plan.steps.size(); ++i) sum.add(plan.steps[i]);
  return sum.cost();
}

PlanCost cost_of(const Protocol& protocol, const Plan& plan, const PlanStep& step) {
  CostSum sum(protocol, plan);
  sum.add(step);
  return sum.cost();
}

}  // namespace asperity
