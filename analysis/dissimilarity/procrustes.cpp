// Rotations by singular value decomposition, and permutations of items.

#include "analysis/dissimilarity/procrustes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/dense.h"

namespace asperity {
namespace {

/// Permuted values are as large as the observed one where rounding alone separates them.
constexpr double kEqualButForRounding = 1e-12;

struct Shape {
  Eigen::MatrixXd unit{};  ///< centred, sum of squares 1
  Eigen::RowVectorXd centre{};
  double size = 0.0;
};

std::optional<Shape> shape_of(const Eigen::MatrixXd& points) {
  Shape shape{.centre = points.colwise().mean()};
  shape.unit = points.rowwise() - shape.centre;
  shape.size = shape.unit.norm();
  if (!(shape.size > 1e-12 * (1.0 + points.cwiseAbs().maxCoeff()))) return std::nullopt;
  shape.unit /= shape.size;
  return shape;
}

void refuse_unequal_numbers(Eigen::Index x, Eigen::Index y) {
  if (x != y) {
    throw std::invalid_argument("the configurations have " + std::to_string(x) + " and " +
                                std::to_string(y) + " items; both must have the same items");
  }
}

double correlation_of(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
  return singular_values(x.transpose() * y).sum();
}

Eigen::PermutationMatrix<Eigen::Dynamic> permutation_of(Eigen::Index m, Random& random) {
  Eigen::PermutationMatrix<Eigen::Dynamic> order(m);
  order.setIdentity();
  random.shuffle(std::span(order.indices().data(), static_cast<std::size_t>(m)));
  return order;
}

}  // namespace

std::optional<Procrustes> procrustes(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
  refuse_unequal_numbers(x.rows(), y.rows());
  const std::optional<Shape> target = shape_of(x);
  const std::optional<Shape> turned = shape_of(y);
  if (!target || !turned) return std::nullopt;
  const SingularValues svd = singular_value_decomposition(target->unit.transpose() * turned->unit);
  const double r = svd.values.sum();
  Procrustes answer{.r_squared = std::min(1.0, r * r)};
  // min over T of |X − c·Y·T|²: T = V·Uᵀ of XᵀY = U·Σ·Vᵀ, and c = Σσ for shapes of size 1.
  answer.fitted = target->size * r * turned->unit * svd.v * svd.u.transpose();
  answer.fitted.rowwise() += target->centre;
  return answer;
}

std::optional<Protest> protest(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y,
                               std::size_t draws, Random random) {
  refuse_unequal_numbers(x.rows(), y.rows());
  const std::optional<Shape> target = shape_of(x);
  const std::optional<Shape> turned = shape_of(y);
  if (!target || !turned) return std::nullopt;
  const double observed = correlation_of(target->unit, turned->unit);
  std::size_t as_large = 1;  // the observed order
  for (std::size_t draw = 0; draw < draws; ++draw) {
    const auto order = permutation_of(y.rows(), random);
    if (correlation_of(target->unit, order * turned->unit) >= observed - kEqualButForRounding)
      ++as_large;
  }
  return Protest{.r_squared = std::min(1.0, observed * observed),
                 .p = static_cast<double>(as_large) / static_cast<double>(draws + 1),
                 .drawn = draws};
}

std::optional<PropertyFit> property_fit(const Eigen::MatrixXd& points,
                                        const Eigen::VectorXd& property, std::size_t draws,
                                        Random random) {
  refuse_unequal_numbers(points.rows(), property.size());
  if (points.rows() < points.cols() + 2) return std::nullopt;
  const std::optional<Shape> shape = shape_of(property);
  if (!shape) return std::nullopt;
  const Eigen::MatrixXd centred = points.rowwise() - points.colwise().mean();
  const LeastSquaresFactors factors(centred);
  const Eigen::VectorXd slopes = factors.solved(shape->unit.col(0));
  const Eigen::MatrixXd basis = factors.basis();
  // Of a property of variance 1, R² is the squared length of its projection on the space of the coordinates.
  const double observed = (basis.transpose() * shape->unit).squaredNorm();
  std::size_t as_large = 1;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    const auto order = permutation_of(points.rows(), random);
    if ((basis.transpose() * (order * shape->unit)).squaredNorm() >=
        observed - kEqualButForRounding)
      ++as_large;
  }
  const double length = slopes.norm();
  return PropertyFit{.direction = length > 0.0 ? Eigen::VectorXd(slopes / length) : slopes,
                     .r_squared = std::min(1.0, observed),
                     .p = static_cast<double>(as_large) / static_cast<double>(draws + 1),
                     .drawn = draws};
}

}  // namespace asperity
