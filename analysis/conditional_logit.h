// Choices among sets of alternatives whose utilities are linear in unknown parameters.

#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace asperity {

/// What was chosen, in strata. Alternative a of a stratum has the utility η_a = Σ w·β over its
/// terms and is chosen with probability exp(η_a)/Σ exp(η) over the stratum. Bradley–Terry,
/// Davidson's ties, an advantage of the first and Plackett–Luce are all of this form.
class ChoiceData final {
 public:
  struct Term {
    std::size_t parameter = 0;
    double weight = 1.0;
  };

  void begin_stratum() { strata_.push_back(counts_.size()); }
  /// Of the stratum that was begun last; `count`: how often it was chosen.
  void add(double count, std::span<const Term> terms);
  void add(double count, std::initializer_list<Term> terms) {
    add(count, std::span(terms.begin(), terms.size()));
  }

  std::size_t strata() const noexcept { return strata_.size(); }
  std::size_t parameters() const noexcept { return parameters_; }

  /// Σ count·ln P.
  double log_likelihood(const Eigen::VectorXd& coefficients) const;
  /// The same with a probability of its own for each alternative of each stratum: no model does
  /// better.
  double largest_log_likelihood() const;

  struct Slopes {
    double log_likelihood = 0.0;
    Eigen::VectorXd score{};        ///< ∂/∂β
    Eigen::MatrixXd information{};  ///< −∂²/∂β²
    Eigen::MatrixXd scores{};       ///< by cluster, a row each; empty without clusters
  };
  /// `clusters`: of each stratum, numbered from 0; may be empty.
  Slopes slopes(const Eigen::VectorXd& coefficients,
                std::span<const std::size_t> clusters = {}) const;

 private:
  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  Range stratum(std::size_t index) const;
  Range terms(std::size_t alternative) const;
  double utility(std::size_t alternative, const Eigen::VectorXd& coefficients) const;

  std::size_t parameters_ = 0;
  std::vector<std::size_t> strata_{};  ///< the first alternative of each
  std::vector<double> counts_{};       ///< by alternative
  std::vector<std::size_t> ends_{};    ///< of the terms of each alternative
  std::vector<Term> terms_{};
};

/// Where the likelihood is largest.
struct ConditionalLogit {
  Eigen::VectorXd coefficients{};
  Eigen::MatrixXd covariance{};  ///< the inverse of the information
  double log_likelihood = 0.0;
};

/// By Newton's method. Nothing where no finite maximum is found: the data decide a comparison
/// completely, or say nothing about a parameter.
std::optional<ConditionalLogit> conditional_logit(const ChoiceData& data);

/// The covariance that lets the strata of a cluster depend on each other in whatever way: V·ΣUU'·V
/// with the score U of each cluster (CR0, without a correction for few clusters).
Eigen::MatrixXd clustered_covariance(const ConditionalLogit& fit, const ChoiceData& data,
                                     std::span<const std::size_t> clusters);

}  // namespace asperity
