// The psi procedure with nuisance parameters marginalised: its levels and the probabilities of the parameters.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/findings/tidy/bayesian_tracks.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

PsychometricShape shape_of_psi(const FamilyOptions& options) {
  const std::string shape = options.text("shape");
  if (shape == "logistic") return PsychometricShape::logistic;
  if (shape == "normal") return PsychometricShape::normal;
  throw std::runtime_error("the option \"shape\" is \"" + shape +
                           "\"; it must be logistic or normal");
}

std::vector<GridParameter> parameters_of_psi(const FamilyOptions& options) {
  std::vector<GridParameter> parameters{};
  for (const char* const name : {"alpha", "beta", "gamma", "lambda"}) {
    parameters.push_back({.name = name, .values = options.numbers(name)});
  }
  if (!options.has("nuisance")) return parameters;
  for (const std::string& name : options.texts("nuisance")) {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(),
                     [&name](const GridParameter& parameter) { return parameter.name == name; });
    if (found == parameters.end()) {
      throw std::runtime_error("the option \"nuisance\" names \"" + name +
                               "\"; the parameters are alpha, beta, gamma and lambda");
    }
    found->is_nuisance = true;
  }
  const bool all_are_nuisances =
      std::all_of(parameters.begin(), parameters.end(),
                  [](const GridParameter& parameter) { return parameter.is_nuisance; });
  if (all_are_nuisances) {
    throw std::runtime_error(
        "the option \"nuisance\" names all parameters; leave out those of interest");
  }
  return parameters;
}

}  // namespace

std::vector<Finding> psi_findings(const TidyInput& input) {
  const PsychometricShape shape = shape_of_psi(input.options);
  const ParameterGrid grid(
      parameters_of_psi(input.options),
      [shape](const std::vector<double>& values) {
        return PsychometricFunction{.shape = shape,
                                    .alpha = values[0],
                                    .beta = std::pow(10.0, values[1]),
                                    .gamma = values[2],
                                    .lambda = values[3]};
      },
      input.options.numbers("stim"));
  FindingList findings{};
  add_bayesian_track(grid, input.table(), "the marginal distribution of the parameters of interest",
                     findings);
  return findings.take();
}

}  // namespace asperity
