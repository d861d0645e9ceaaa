// QUEST+ in one dimension: its levels and the probabilities of the parameters.

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/findings/tidy/bayesian_tracks.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// The function of α, β and λ. A Weibull function of a level in dB is a Gumbel function with the slope β/20 per dB.
FunctionOfValues function_of_questplus(const FamilyOptions& options) {
  const std::string shape = options.text("shape");
  const double gamma = options.number("gamma");
  if (shape == "weibull_db") {
    return [gamma](const std::vector<double>& values) {
      return PsychometricFunction{.shape = PsychometricShape::gumbel,
                                  .alpha = values[0],
                                  .beta = values[1] / 20.0,
                                  .gamma = gamma,
                                  .lambda = values[2]};
    };
  }
  if (shape == "normal") {
    return [gamma](const std::vector<double>& values) {
      return PsychometricFunction{.shape = PsychometricShape::normal,
                                  .alpha = values[0],
                                  .beta = 1.0 / values[1],
                                  .gamma = gamma,
                                  .lambda = values[2]};
    };
  }
  throw std::runtime_error("the option \"shape\" is \"" + shape +
                           "\"; it must be weibull_db or normal");
}

void add_modes(const ParameterGrid& grid, const Eigen::ArrayXd& weights, std::size_t trials,
               FindingList& findings) {
  const Basis after{.n = trials, .method = "after the last response"};
  for (std::size_t parameter = 0; parameter < grid.parameters().size(); ++parameter) {
    std::map<double, double> sums{};
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      sums[grid.value(parameter, static_cast<std::size_t>(i))] += weights[i];
    }
    auto most = sums.begin();
    for (auto each = sums.begin(); each != sums.end(); ++each) {
      if (each->second > most->second) most = each;
    }
    findings.number("marginal.mode", grid.parameters()[parameter].name, most->first, after);
  }
  Eigen::Index joint = 0;
  const double probability = weights.maxCoeff(&joint);
  for (std::size_t parameter = 0; parameter < grid.parameters().size(); ++parameter) {
    findings.number("joint.mode", grid.parameters()[parameter].name,
                    grid.value(parameter, static_cast<std::size_t>(joint)), after);
  }
  findings.number("joint.mode.p", "", probability, after);
}

}  // namespace

std::vector<Finding> questplus_findings(const TidyInput& input) {
  std::vector<GridParameter> parameters{};
  for (const char* const name : {"alpha", "beta", "lambda"}) {
    parameters.push_back({.name = name, .values = input.options.numbers(name)});
  }
  const ParameterGrid grid(std::move(parameters), function_of_questplus(input.options),
                           input.options.numbers("stim"));
  FindingList findings{};
  const Eigen::ArrayXd weights =
      add_bayesian_track(grid, input.table(), "the distribution of all parameters", findings);
  add_modes(grid, weights, input.table().rows(), findings);
  return findings.take();
}

}  // namespace asperity
