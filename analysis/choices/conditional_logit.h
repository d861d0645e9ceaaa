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
    std::vector<Eigen::MatrixXd> informations{};  ///< by cluster; empty without clusters
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

/// Fewer clusters show too little of how clusters differ.
inline constexpr std::size_t kFewestClusters = 5;

/// A standard error with the degrees of freedom of its t distribution.
struct ClusteredError {
  double standard_error = 0.0;
  double df = 1.0;
};

/// Of c'β for each row c of `combinations`, with few clusters: CR2 and Satterthwaite's degrees of
/// freedom [Bell 2002], [Pustejovsky 2018], with the model itself as the working model. Empty with
/// fewer than `kFewestClusters` clusters.
///
/// At the estimate the score of cluster g is Û_g = U_g − I_g·V·ΣU, of covariance I_g − I_g·V·I_g
/// under the model, less than the information I_g: CR0 is too small. With M_g = V^½·I_g·V^½ and
/// s_g = V^½·Û_g, A_g = (I − M_g)^−½ gives A_g·s_g the covariance M_g, so that
/// V^½·Σ(A_g·s_g)(A_g·s_g)'·V^½ has the expectation V. Its c'·c is the sum of the squares of
/// ℓ_g = a_g's_g, a_g = A_g·V^½·c, with Cov(ℓ_g, ℓ_k) = a_g'(δ_gk·M_g − M_g·M_k)a_k =: Γ_gk, and
/// df = (tr Γ)²/tr Γ². Clusters of equal information: the factor G/(G − 1) and df = G − 1.
///
/// [Bell 2002] Bell, McCaffrey: Bias reduction in standard errors for linear regression with
/// multi-stage samples. [Pustejovsky 2018] Pustejovsky, Tipton: Small-sample methods for
/// cluster-robust variance estimation and hypothesis testing in fixed effects models.
std::vector<ClusteredError> clustered_errors(const ConditionalLogit& fit, const ChoiceData& data,
                                             std::span<const std::size_t> clusters,
                                             const Eigen::MatrixXd& combinations);

}  // namespace asperity
