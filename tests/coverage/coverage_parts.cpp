// Lists the parts, and computes true values by integrals over the random effects.

#include "tests/coverage/coverage_parts.h"

#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace asperity {

std::vector<CoveragePart> coverage_parts() {
  std::vector<CoveragePart> parts{};
  for (const auto of_subject :
       {choice_parts, matching_parts, scale_parts, time_parts, agreement_parts, difference_parts,
        model_parts, detection_parts, discrimination_parts, left_out_parts, rating_parts,
        exploration_parts, similarity_parts}) {
    parts.insert(parts.end(), of_subject().begin(), of_subject().end());
  }
  return parts;
}

std::vector<CoverageSetting> all_designs(std::span<const double> effects,
                                         std::span<const double> spreads) {
  constexpr std::pair<std::size_t, std::size_t> kDesigns[]{{20, 3}, {12, 12}, {6, 20}, {5, 12},
                                                           {4, 12}, {3, 12},  {2, 12}};
  std::vector<CoverageSetting> settings{};
  for (const auto& [participants, trials] : kDesigns) {
    for (const double spread : spreads) {
      for (const double effect : effects) {
        settings.push_back(
            {.participants = participants, .trials = trials, .effect = effect, .spread = spread});
      }
    }
  }
  return settings;
}

double mean_over_normal(const std::function<double(double)>& of) {
  // The trapezium rule converges geometrically for a smooth integrand that vanishes at both ends.
  constexpr int kSteps = 200;
  constexpr double kFurthest = 9.0;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double z = kFurthest * (2.0 * i / kSteps - 1.0);
    const double weight = std::exp(-0.5 * z * z);
    sum += weight * of(z);
    weights += weight;
  }
  return sum / weights;
}

double mean_of_logistic(double mu, double spread) {
  return mean_over_normal(
      [mu, spread](double z) { return 1.0 / (1.0 + std::exp(-(mu + spread * z))); });
}

double mu_of_mean(double mean, double spread) {
  if (!(mean > 0.0 && mean < 1.0)) throw std::invalid_argument("a mean proportion lies in (0, 1)");
  // Thousands of tables of a setting ask for the same.
  thread_local std::map<std::pair<double, double>, double> known{};
  const auto [place, is_new] = known.try_emplace({mean, spread}, 0.0);
  if (!is_new) return place->second;
  double low = -40.0;
  double high = 40.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (mean_of_logistic(middle, spread) < mean ? low : high) = middle;
  }
  return place->second = 0.5 * (low + high);
}

ThreeItems own_weights(const ThreeItems& mean_utilities, double spread, Random& random) {
  ThreeItems weights{};
  for (std::size_t j = 0; j < weights.size(); ++j) {
    weights[j] = std::exp(mean_utilities[j] + spread * random.normal());
  }
  return weights;
}

ThreeItems mean_choices(const ThreeItems& mean_utilities, double spread) {
  const int steps = spread > 0.0 ? 60 : 0;
  constexpr double kFurthest = 6.0;
  const auto place = [steps](int i) {
    return steps == 0 ? 0.0 : kFurthest * (2.0 * i / steps - 1.0);
  };
  ThreeItems sum{};
  double all = 0.0;
  for (int a = 0; a <= steps; ++a) {
    for (int b = 0; b <= steps; ++b) {
      for (int c = 0; c <= steps; ++c) {
        const ThreeItems z{place(a), place(b), place(c)};
        const double weight = std::exp(-0.5 * (z[0] * z[0] + z[1] * z[1] + z[2] * z[2]));
        ThreeItems own{};
        for (std::size_t j = 0; j < own.size(); ++j) {
          own[j] = std::exp(mean_utilities[j] + spread * z[j]);
        }
        const double total = std::accumulate(own.begin(), own.end(), 0.0);
        for (std::size_t j = 0; j < own.size(); ++j) sum[j] += weight * own[j] / total;
        all += weight;
      }
    }
  }
  for (double& one : sum) one /= all;
  return sum;
}

std::vector<CheckedInterval> no_intervals(const CoverageSetting&) { return {}; }
std::vector<CheckedTest> no_tests(const CoverageSetting&) { return {}; }

void DrawnTable::add(std::initializer_list<std::string_view> cells) {
  const char* between = "";
  for (const std::string_view cell : cells) {
    text_ += between;
    text_ += cell;
    between = ",";
  }
  text_ += '\n';
}

TidyInput DrawnTable::as_input() && {
  TidyInput input{};
  input.tables.emplace_back(std::move(text_), "drawn.csv");
  return input;
}

std::string participant_label(std::size_t participant) {
  const std::string number = std::to_string(participant + 1);
  return number.size() < 2 ? "S0" + number : "S" + number;
}

std::size_t drawn_by_weight(std::span<const double> weights, Random& random) {
  double left = random.uniform() * std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    left -= weights[i];
    if (left < 0.0) return i;
  }
  return weights.size() - 1;
}

}  // namespace asperity
