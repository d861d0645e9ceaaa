// Implements the estimate of a session's duration.

#include <algorithm>
#include <cstddef>
#include <string>

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

}  // namespace

PlanCost cost_of(const Protocol& protocol, const Plan& plan) {
  PlanCost cost{};
  double since_break_s = 0.0;
  const auto spend = [&](double time_s) {
    cost.total_s += time_s;
    since_break_s += time_s;
    cost.longest_without_break_s = std::max(cost.longest_without_break_s, since_break_s);
  };
  for (const PlanStep& step : plan.steps) {
    if (const auto* const screen = std::get_if<Protocol::Screen>(&step)) {
      spend(reading_s(screen->text));
    } else if (std::holds_alternative<Protocol::Check>(step)) {
      spend(kCheck_s);
    } else if (const auto* const ask = std::get_if<Protocol::Ask>(&step)) {
      spend(kQuestion_s * static_cast<double>(ask->questions.size()));
    } else if (const auto* const pause = std::get_if<Protocol::Break>(&step)) {
      cost.total_s += pause->minimum_s;
      since_break_s = 0.0;
    } else {
      const Trial& trial = plan.trials[std::get<TrialStep>(step).trial];
      const Protocol::Block& block = protocol.blocks.at(trial.block);
      const auto surfaces = static_cast<double>(trial.presentations.size());
      const double felt_s = surfaces * contact_s(exploration_of(protocol, trial));
      ++cost.trials;
      cost.contacts += static_cast<int>(trial.presentations.size());
      cost.contact_s += felt_s;
      double answers = 0.0;
      for (const TrialQuestion& question : trial.questions) {
        answers += items_of(question.form, static_cast<int>(trial.presentations.size()));
      }
      spend(felt_s + block.pause_before_trial_s +
            (surfaces - 1.0) * block.pause_between_surfaces_s + kChoice_s * answers +
            (block.feedback == Protocol::Block::Feedback::none ? 0.0 : kFeedback_s));
    }
  }
  return cost;
}

}  // namespace asperity
