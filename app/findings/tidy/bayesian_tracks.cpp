// Presents the level of least expected entropy, applies Bayes' rule to the response, and repeats.

#include "app/findings/tidy/bayesian_tracks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

constexpr double kMostTableNumbers = 1e7;  // 80 MB

/// The indices of the parameters: those of interest first, nuisances last.
std::vector<std::size_t> order_of_parameters(const std::vector<GridParameter>& parameters) {
  std::vector<std::size_t> order{};
  for (const bool nuisances : {false, true}) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].is_nuisance == nuisances) order.push_back(i);
    }
  }
  return order;
}

std::vector<std::vector<double>> combinations_of(const std::vector<GridParameter>& parameters,
                                                 std::size_t levels) {
  auto numbers = static_cast<double>(levels);
  for (const GridParameter& parameter : parameters) {
    if (parameter.values.empty()) {
      throw std::runtime_error("the option \"" + parameter.name +
                               "\" has no value; state at least one");
    }
    numbers *= static_cast<double>(parameter.values.size());
  }
  if (numbers > kMostTableNumbers) {
    throw std::runtime_error("the grid has " + number_text(numbers) +
                             " combinations of levels and values of parameters; reduce their "
                             "numbers to 10000000 combinations or less");
  }
  std::vector<std::vector<double>> all{std::vector<double>(parameters.size())};
  for (const std::size_t parameter : order_of_parameters(parameters)) {
    std::vector<std::vector<double>> extended{};
    for (const std::vector<double>& known : all) {
      for (const double value : parameters[parameter].values) {
        extended.push_back(known);
        extended.back()[parameter] = value;
      }
    }
    all = std::move(extended);
  }
  return all;
}

std::vector<PsychometricFunction> functions_with(
    const std::vector<std::vector<double>>& combinations, const FunctionOfValues& function) {
  std::vector<PsychometricFunction> functions{};
  for (const std::vector<double>& values : combinations) functions.push_back(function(values));
  return functions;
}

std::size_t nuisance_combinations(const std::vector<GridParameter>& parameters) {
  std::size_t count = 1;
  for (const GridParameter& parameter : parameters) {
    if (parameter.is_nuisance) count *= parameter.values.size();
  }
  return count;
}

std::vector<bool> answered_responses(const TidyTable& table) {
  const std::vector<std::uint64_t> trials = table.counts("trial");
  const NumberColumn responses = table.numbers("response");
  std::vector<bool> answered{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (row > 0 && trials[row] <= trials[row - 1]) {
      table.refuse(row, "trial",
                   "trial " + std::to_string(trials[row]) + " follows trial " +
                       std::to_string(trials[row - 1]) +
                       "; list the trials in the order in which they were presented");
    }
    if (!responses[row]) continue;
    if (*responses[row] != 0.0 && *responses[row] != 1.0) {
      table.refuse(row, "response",
                   "response is " + number_text(*responses[row]) +
                       "; it must be 1 (correct, or yes) or 0 (incorrect, or no), or empty");
    }
    answered.push_back(*responses[row] == 1.0);
  }
  return answered;
}

/// The difference between the two smallest of at least two values.
double gap_of_least(std::vector<double> values) {
  std::partial_sort(values.begin(), values.begin() + 2, values.end());
  return values[1] - values[0];
}

}  // namespace

ParameterGrid::ParameterGrid(std::vector<GridParameter> parameters,
                             const FunctionOfValues& function, std::vector<double> levels)
    : parameters_(std::move(parameters)),
      combinations_(combinations_of(parameters_, levels.size())),
      table_(functions_with(combinations_, function), nuisance_combinations(parameters_),
             std::move(levels)) {}

Eigen::ArrayXd add_bayesian_track(const ParameterGrid& grid, const TidyTable& responses,
                                  const std::string& of_what, FindingList& findings) {
  const std::vector<bool> answered = answered_responses(responses);
  const FunctionTable& table = grid.table();
  Eigen::ArrayXd weights = table.uniform();
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t trial = 0; trial < answered.size(); ++trial) {
    const FindingKey key = std::to_string(trial + 1);
    const std::vector<double> entropies = table.expected_entropies(weights);
    const std::size_t level = place_of_least(entropies);
    if (entropies.size() > 1) gap = std::min(gap, gap_of_least(entropies));
    findings.number("stim", key, table.levels()[level],
                    {.n = 1, .method = "level of a trial: the least expected entropy"});
    findings.number("expected.entropy", key, entropies[level],
                    {.n = 1, .method = "expected before the response, in nats, of " + of_what});
    try {
      table.respond(weights, level, answered[trial]);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error("trial " + key.text() + ": " + error.what());
    }
    findings.number("entropy", key, table.entropy(weights),
                    {.n = 1, .method = "after the response, in nats, of " + of_what});
  }
  const Basis after{.n = answered.size(), .method = "after the last response"};
  findings.number("min.tie.gap", "", gap,
                  {.n = answered.size(),
                   .method = "smallest difference between the expected entropies of the best and "
                             "the second-best level"});
  for (std::size_t parameter = 0; parameter < grid.parameters().size(); ++parameter) {
    Eigen::ArrayXd values(weights.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      values[i] = grid.value(parameter, static_cast<std::size_t>(i));
    }
    const double mean = (weights * values).sum();
    const std::string& name = grid.parameters()[parameter].name;
    findings.number("posterior.mean", name, mean, after);
    findings.number("posterior.sd", name, std::sqrt((weights * (values - mean).square()).sum()),
                    after);
  }
  return weights;
}

}  // namespace asperity
