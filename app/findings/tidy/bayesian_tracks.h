// One track of a Bayesian procedure from its responses: the level of every trial, and the probabilities of the parameters.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/psychometric/function_table.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// A parameter of the functions and its values, as an option states them.
struct GridParameter {
  std::string name{};
  std::vector<double> values{};
  bool is_nuisance = false;
};

/// The values of the parameters in their order → a function.
using FunctionOfValues = std::function<PsychometricFunction(const std::vector<double>& values)>;

/// All combinations of the values of parameters, nuisances varying fastest.
class ParameterGrid final {
 public:
  /// Errors: std::runtime_error for a parameter without values, and a grid whose table would exceed 10⁷ numbers.
  ParameterGrid(std::vector<GridParameter> parameters, const FunctionOfValues& function,
                std::vector<double> levels);

  const FunctionTable& table() const noexcept { return table_; }
  const std::vector<GridParameter>& parameters() const noexcept { return parameters_; }
  /// The value of the parameter with this index in a combination.
  double value(std::size_t parameter, std::size_t combination) const {
    return combinations_[combination][parameter];
  }

 private:
  std::vector<GridParameter> parameters_{};
  std::vector<std::vector<double>> combinations_{};
  FunctionTable table_;
};

/// Adds `stim`, `expected.entropy` and `entropy` of every trial in the order of the rows, `min.tie.gap`, and the mean and
/// standard deviation of every parameter. Returns the probabilities after the last response. The table has the columns
/// `trial,response`. `of_what`: the distribution whose entropy it is.
///
/// Errors: std::runtime_error for responses other than 0 and 1, trials that are not numbered in ascending order, and a
/// response that no function of the grid can give.
Eigen::ArrayXd add_bayesian_track(const ParameterGrid& grid, const TidyTable& responses,
                                  const std::string& of_what, FindingList& findings);

}  // namespace asperity
