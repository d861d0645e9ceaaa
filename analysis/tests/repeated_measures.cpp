// Orthonormal contrasts, traces of error matrices, and what corrects for their shape.

#include "analysis/tests/repeated_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <unsupported/Eigen/KroneckerProduct>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

using Factors = std::vector<std::size_t>;

void refuse_no_table(const RepeatedMeasures& data) {
  std::size_t cells = 1;
  for (const std::size_t levels : data.levels) {
    if (levels < 2) {
      throw std::invalid_argument("levels: the number of levels of a factor is " +
                                  std::to_string(levels) + "; it must be at least 2");
    }
    cells *= levels;
  }
  if (data.levels.empty() || static_cast<std::size_t>(data.y.cols()) != cells ||
      !data.y.allFinite()) {
    throw std::invalid_argument("y: the number of columns is " + std::to_string(data.y.cols()) +
                                "; it must have one per cell, " + std::to_string(cells) +
                                ", and all its values must be finite");
  }
  const auto participants = static_cast<std::size_t>(data.y.rows());
  if (participants <= data.groups) {
    throw std::invalid_argument("y: the number of participants is " + std::to_string(participants) +
                                " and that of groups is " + std::to_string(data.groups) +
                                "; an error term requires more participants than groups");
  }
  if (data.groups > 1) {
    if (data.group.size() != participants) {
      throw std::invalid_argument(
          "group has an entry that is not a group, or not one entry per participant; it must have "
          "the group of each");
    }
    for (std::size_t group = 0; group < data.groups; ++group) {
      if (std::count(data.group.begin(), data.group.end(), group) == 0) {
        throw std::invalid_argument(
            "group " + std::to_string(group + 1) +
            " has no participant with all cells; each group needs at least one");
      }
    }
  }
}

// Columns orthonormal and orthogonal to 1: Helmert's, normalised.
Eigen::MatrixXd contrasts(std::size_t levels) {
  const auto k = static_cast<Eigen::Index>(levels);
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(k, k - 1);
  for (Eigen::Index j = 0; j < k - 1; ++j) {
    c.col(j).head(j + 1).setConstant(-1.0);
    c(j + 1, j) = static_cast<double>(j + 1);
    c.col(j).normalize();
  }
  return c;
}

Eigen::MatrixXd effect_contrasts(const RepeatedMeasures& data, const Factors& within) {
  Eigen::MatrixXd product = Eigen::MatrixXd::Ones(1, 1);
  for (std::size_t factor = 0; factor < data.levels.size(); ++factor) {
    const std::size_t levels = data.levels[factor];
    const bool is_in = std::find(within.begin(), within.end(), factor) != within.end();
    const auto k = static_cast<Eigen::Index>(levels);
    const Eigen::MatrixXd one =
        is_in ? contrasts(levels)
              : Eigen::MatrixXd(Eigen::VectorXd::Constant(k, 1.0 / std::sqrt(double(k))));
    product = Eigen::kroneckerProduct(product, one).eval();
  }
  return product;
}

std::vector<Factors> subsets(std::size_t factors) {
  std::vector<Factors> all{{}};
  for (std::size_t factor = 0; factor < factors; ++factor) {
    const std::vector<Factors> before = all;
    for (Factors with : before) {
      with.push_back(factor);
      all.push_back(std::move(with));
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Factors& a, const Factors& b) { return a.size() < b.size(); });
  return all;
}

// Contrasts Z of all participants, by group: sizes, means, and squares about the means.
struct Grouped {
  Eigen::VectorXd sizes{};
  Eigen::MatrixXd means{};  // groups × contrasts
  Eigen::MatrixXd error{};  // S
};

Grouped grouped(const RepeatedMeasures& data, const Eigen::MatrixXd& z) {
  const auto groups = static_cast<Eigen::Index>(data.groups);
  const auto group_of = [&](Eigen::Index row) {
    return data.groups > 1 ? static_cast<Eigen::Index>(data.group[static_cast<std::size_t>(row)])
                           : Eigen::Index{0};
  };
  Grouped answer{.sizes = Eigen::VectorXd::Zero(groups),
                 .means = Eigen::MatrixXd::Zero(groups, z.cols())};
  for (Eigen::Index row = 0; row < z.rows(); ++row) {
    answer.sizes(group_of(row)) += 1.0;
    answer.means.row(group_of(row)) += z.row(row);
  }
  answer.means.array().colwise() /= answer.sizes.array();
  Eigen::MatrixXd residuals = z;
  for (Eigen::Index row = 0; row < z.rows(); ++row) {
    residuals.row(row) -= answer.means.row(group_of(row));
  }
  answer.error = residuals.transpose() * residuals;
  return answer;
}

double within_squares(const Grouped& z, SumsOfSquares type) {
  const auto groups = static_cast<double>(z.sizes.size());
  switch (type) {
    case SumsOfSquares::type_2: {
      const double n = z.sizes.sum();
      return (z.sizes.transpose() * z.means / n).squaredNorm() * n;
    }
    case SumsOfSquares::type_3:
      // The variance of an unweighted mean of means is Σ(1/n_g)/G² of that of one participant.
      return z.means.colwise().mean().squaredNorm() * groups * groups /
             z.sizes.cwiseInverse().sum();
  }
  throw std::invalid_argument("type is not one of SumsOfSquares; it must be type_2 or type_3");
}

// Differences between the groups, weighted by their sizes: the same for both types.
double between_squares(const Grouped& z) {
  const Eigen::RowVectorXd mean = z.sizes.transpose() * z.means / z.sizes.sum();
  const Eigen::MatrixXd differences = z.means.rowwise() - mean;
  return (differences.rowwise().squaredNorm().array() * z.sizes.array()).sum();
}

std::optional<double> ratio(double above, double below) {
  return below > 0.0 ? std::optional<double>(above / below) : std::nullopt;
}

std::optional<double> corrected_p(const AnovaEffect& effect, const std::optional<double>& epsilon) {
  if (!effect.F || !epsilon) {
    return std::nullopt;
  }
  return upper_tail(
      FStatistic{.value = *effect.F, .df1 = effect.df1 * *epsilon, .df2 = effect.df2 * *epsilon});
}

struct ErrorMatrix {
  Eigen::MatrixXd S{};
  double df = 0.0;  // f
  double cells = 0.0;
};

std::optional<AnovaEffect::Sphericity::Mauchly> mauchly(const ErrorMatrix& error) {
  const auto q = static_cast<double>(error.S.rows());
  const double f = error.df;
  if (f < q) {
    return std::nullopt;
  }
  const Eigen::ArrayXd relative = eigenvalues(error.S).array() / (error.S.trace() / q);
  AnovaEffect::Sphericity::Mauchly answer{.W = relative.prod()};
  if (!(answer.W > 0.0)) {
    return std::nullopt;
  }
  const double rho = 1.0 - (2.0 * q * q + q + 2.0) / (6.0 * q * f);
  answer.chi_squared = -f * rho * std::log(answer.W);
  answer.df = q * (q + 1.0) / 2.0 - 1.0;
  const std::optional<double> first =
      upper_tail(ChiSquaredStatistic{.value = answer.chi_squared, .df = answer.df});
  const std::optional<double> further =
      upper_tail(ChiSquaredStatistic{.value = answer.chi_squared, .df = answer.df + 4.0});
  const auto second_order = [&](double p) {
    const double weight = (q + 2.0) * (q - 1.0) * (q - 2.0) *
                          (2.0 * q * q * q + 6.0 * q * q + 3.0 * p + 2.0) /
                          (288.0 * (f * q * rho) * (f * q * rho));
    return *first + weight * (*further - *first);
  };
  answer.p_first_order = first;
  if (first && further) {
    answer.p_second_order = second_order(q);
    answer.p_as_r = second_order(error.cells);
  }
  return answer;
}

AnovaEffect::Sphericity sphericity(const AnovaEffect& effect, const ErrorMatrix& error,
                                   double participants) {
  const auto q = static_cast<double>(error.S.rows());
  const double trace = error.S.trace();
  AnovaEffect::Sphericity answer{.lower_bound = 1.0 / q};
  answer.gg = ratio(trace * trace, q * error.S.squaredNorm());
  if (answer.gg) {
    const double free = error.df - q * *answer.gg;
    constexpr double kRounding = 1e-12;
    if (free > kRounding * error.df) {
      const auto huynh_feldt = [&](double n) { return (n * q * *answer.gg - 2.0) / (q * free); };
      answer.hf_lecoutre = huynh_feldt(error.df + 1.0);
      answer.hf_original = huynh_feldt(participants);
    }
  }
  answer.p_gg = corrected_p(effect, answer.gg);
  answer.p_hf =
      answer.hf_lecoutre ? corrected_p(effect, std::min(1.0, *answer.hf_lecoutre)) : std::nullopt;
  answer.p_lower_bound = corrected_p(effect, answer.lower_bound);
  answer.mauchly = mauchly(error);
  return answer;
}

}  // namespace

AnovaTable repeated_measures_anova(const RepeatedMeasures& data, SumsOfSquares type) {
  refuse_no_table(data);
  const auto participants = static_cast<double>(data.y.rows());
  const double f = participants - static_cast<double>(data.groups);
  // Contrasts of equal numbers are rounding, not zero: squares below this are nobody's, and no F, no p
  // and no share of them means anything.
  const double rounding =
      8.0 * std::numeric_limits<double>::epsilon() * data.y.cwiseAbs().maxCoeff();
  const double no_squares = static_cast<double>(data.y.size()) * rounding * rounding;
  const auto squares_of = [no_squares](double sum) { return sum <= no_squares ? 0.0 : sum; };
  AnovaTable table;
  std::vector<ErrorMatrix> errors;
  for (const Factors& within : subsets(data.levels.size())) {
    const Eigen::MatrixXd c = effect_contrasts(data, within);
    Grouped z = grouped(data, data.y * c);
    if (z.error.trace() <= no_squares) z.error.setZero();
    const auto q = static_cast<double>(c.cols());
    const ErrorMatrix error{.S = z.error, .df = f, .cells = static_cast<double>(data.y.cols())};
    table.all_errors += z.error.trace();
    const auto add = [&](bool between, double squares, double df) {
      AnovaEffect effect{.within = within, .between = between};
      effect.sum_of_squares = squares_of(squares);
      effect.error_sum_of_squares = z.error.trace();
      effect.df1 = df;
      effect.df2 = q * f;
      table.effects.push_back(effect);
      errors.push_back(error);
    };
    if (!within.empty()) {
      add(false, within_squares(z, type), q);
    }
    if (data.groups > 1) {
      add(true, between_squares(z), q * (static_cast<double>(data.groups) - 1.0));
    }
  }

  double measured = 0.0;
  for (const AnovaEffect& effect : table.effects) {
    measured += effect.between ? effect.sum_of_squares : 0.0;
  }
  for (std::size_t i = 0; i < table.effects.size(); ++i) {
    AnovaEffect& effect = table.effects[i];
    const double squares = effect.sum_of_squares;
    const double error = effect.error_sum_of_squares;
    const double error_mean = error / effect.df2;
    effect.F = ratio(squares / effect.df1, error_mean);
    if (effect.F) {
      effect.p = upper_tail(FStatistic{.value = *effect.F, .df1 = effect.df1, .df2 = effect.df2});
    }
    effect.pes = ratio(squares, squares + error);
    effect.ges = ratio(squares, squares + table.all_errors);
    if (data.groups > 1) {
      effect.ges_observed =
          ratio(squares, (effect.between ? 0.0 : squares) + table.all_errors + measured);
    }
    effect.omega2 = ratio(squares - effect.df1 * error_mean, squares + error + error_mean);
    if (errors[i].S.rows() >= 2) {
      effect.sphericity = sphericity(effect, errors[i], participants);
    }
  }
  return table;
}

CellMeans cell_means(const Eigen::MatrixXd& y, double confidence) {
  if (y.rows() < 1 || y.cols() < 1) {
    throw std::invalid_argument("y is empty; at least one participant and one cell are needed");
  }
  CellMeans answer{.mean = y.colwise().mean()};
  const auto n = static_cast<double>(y.rows());
  const std::optional<double> t = t_limit({.confidence = confidence, .df = n - 1.0});
  if (!t) {
    return answer;
  }
  const auto half_widths = [&](const Eigen::MatrixXd& rows) {
    const Eigen::MatrixXd centred = rows.rowwise() - rows.colwise().mean();
    const Eigen::VectorXd squares = centred.colwise().squaredNorm();
    return Eigen::VectorXd(*t * (squares / ((n - 1.0) * n)).cwiseSqrt());
  };
  answer.half_width = half_widths(y);
  if (y.cols() > 1) {
    const auto cells = static_cast<double>(y.cols());
    const Eigen::MatrixXd own = y.colwise() - y.rowwise().mean();
    answer.within_half_width = half_widths(own) * std::sqrt(cells / (cells - 1.0));
  }
  return answer;
}

Eigen::MatrixXd marginal_means(const RepeatedMeasures& data, std::size_t factor) {
  refuse_no_table(data);
  if (factor >= data.levels.size()) {
    throw std::invalid_argument("factor is " + std::to_string(factor) + "; it must be below " +
                                std::to_string(data.levels.size()));
  }
  std::size_t inner = 1;  // cells that run within one level
  for (std::size_t i = factor + 1; i < data.levels.size(); ++i) {
    inner *= data.levels[i];
  }
  const std::size_t levels = data.levels[factor];
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(data.y.rows(), static_cast<Eigen::Index>(levels));
  for (Eigen::Index cell = 0; cell < data.y.cols(); ++cell) {
    const std::size_t level = static_cast<std::size_t>(cell) / inner % levels;
    means.col(static_cast<Eigen::Index>(level)) += data.y.col(cell);
  }
  return means * static_cast<double>(levels) / static_cast<double>(data.y.cols());
}

Eigen::MatrixXd orthonormal_polynomials(const Eigen::VectorXd& levels, std::size_t degrees) {
  const auto k = static_cast<Eigen::Index>(degrees);
  // The columns 1, x, x², … made orthogonal one after the other; twice, which is enough.
  Eigen::MatrixXd basis(levels.size(), k + 1);
  const Eigen::ArrayXd centred = levels.array() - levels.mean();
  const double scale = centred.abs().maxCoeff();
  Eigen::ArrayXd power = Eigen::ArrayXd::Ones(levels.size());
  for (Eigen::Index degree = 0; degree <= k; ++degree) {
    Eigen::VectorXd next = power.matrix();
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index j = 0; j < degree; ++j) {
        next -= basis.col(j).dot(next) * basis.col(j);
      }
    }
    constexpr double kVanished = 1e-10;
    if (!(scale > 0.0) || !(next.norm() > kVanished)) {
      throw std::invalid_argument(
          "levels has too few different numbers; polynomials up to degree " +
          std::to_string(degrees) + " require " + std::to_string(degrees + 1));
    }
    basis.col(degree) = next.normalized();
    power *= centred / scale;
  }
  return basis.rightCols(k);
}

}  // namespace asperity
