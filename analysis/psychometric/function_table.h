// Bayesian choice of the next level: probabilities of psychometric functions, and the entropy expected after a trial.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/psychometric/psychometric_function.h"

namespace asperity {

/// The values of psychometric functions at the levels that can be presented, tabulated once.
///
/// Functions f have probabilities w(f), which Bayes' theorem changes after each response r at a level x:
///
///   w′(f) = w(f)·P(r | x, f) / P(r | x),   P(r | x) = Σ_f w(f)·P(r | x, f),   P(hit | x, f) = ψ_f(x).
///
/// Functions that agree in the parameters of interest and differ in the nuisance parameters form a group g with
/// W(g) = Σ_{f in g} w(f), the marginal distribution of the parameters of interest. The entropy expected after a trial at x
///
///   E[H](x) = Σ_r P(r | x)·H(W′),   H(W) = −Σ_g W(g)·ln W(g),   in nats,
///
/// is the criterion of psi with nuisance parameters marginalised [Prins 2013]. With a group per function it is that of psi
/// [Kontsevich 1999] and of QUEST+ [Watson 2017]. With J(g, r) = Σ_{f in g} w(f)·P(r | x, f) it equals
///
///   E[H](x) = Σ_r [P(r | x)·ln P(r | x) − Σ_g J(g, r)·ln J(g, r)],
///
/// which needs no division. With a group per function it is Σ_r P(r | x)·ln P(r | x) + H(w) + Σ_f w(f)·h(ψ_f(x)), with the
/// tabulated h(ψ) = −ψ·ln ψ − (1 − ψ)·ln(1 − ψ), and needs no logarithm of single functions. For equal probabilities and a level at which all functions agree, E[H] = H: the trial is useless.
///
/// The table is immutable: one can serve many tracks at a time.
///
/// [Kontsevich 1999] Kontsevich, Tyler: Bayesian adaptive estimation of psychometric slope and threshold.
/// [Prins 2013] Prins: The psi-marginal adaptive method.
/// [Watson 2017] Watson: QUEST+: A general multidimensional Bayesian adaptive psychometric method.
class FunctionTable final {
 public:
  /// `of_group`: the number of functions of each group, which follow each other. Errors: std::invalid_argument where there
  /// is no function or no level, or the functions do not form whole groups.
  FunctionTable(std::vector<PsychometricFunction> functions, std::size_t of_group,
                std::vector<double> levels);

  const std::vector<PsychometricFunction>& functions() const noexcept { return functions_; }
  const std::vector<double>& levels() const noexcept { return levels_; }

  /// The same probability for each function.
  Eigen::ArrayXd uniform() const;
  /// Bayes' theorem after a response at a level of the table, or at another one. Errors: std::invalid_argument where no
  /// function with a probability can give this response.
  void respond(Eigen::ArrayXd& weights, std::size_t level, bool is_hit) const;
  void respond_at(Eigen::ArrayXd& weights, double x, bool is_hit) const;
  /// The same after a response "cannot tell", which counts as the mean of a guess that is a hit with the probability `chance`:
  ///
  ///   w′(f) ∝ w(f)·ψ_f(x)^chance·(1 − ψ_f(x))^(1 − chance).
  void guess(Eigen::ArrayXd& weights, std::size_t level, double chance) const;
  void guess_at(Eigen::ArrayXd& weights, double x, double chance) const;
  /// W by group.
  Eigen::ArrayXd marginal(const Eigen::ArrayXd& weights) const;
  /// H(W).
  double entropy(const Eigen::ArrayXd& weights) const;
  /// E[H] by level.
  std::vector<double> expected_entropies(const Eigen::ArrayXd& weights) const;

 private:
  double expected_by_groups(const Eigen::ArrayXd& weights, const Eigen::ArrayXd& marginal,
                            Eigen::Index level) const;
  double expected_by_functions(const Eigen::ArrayXd& weights, double entropy,
                               Eigen::Index level) const;

  std::vector<PsychometricFunction> functions_{};
  Eigen::Index of_group_ = 1;
  std::vector<double> levels_{};
  Eigen::ArrayXXd values_{};       // ψ, a column per level
  Eigen::ArrayXXd own_entropy_{};  // h(ψ), the same; with a group per function
};

/// The place of the least value; of values that differ from it by rounding alone (10⁻¹⁰), the first. The choice between
/// equally good levels therefore does not depend on the machine.
std::size_t place_of_least(std::span<const double> values);

}  // namespace asperity
