// The integral by Gauss–Kronrod, its inverse by TOMS 748.

#include "analysis/choices/forced_choice.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

constexpr double kReach = 12.0;  // φ(12) is 2·10⁻³²
constexpr unsigned kDepth = 6;
constexpr double kPrecision = 1e-13;

template <class Integrand>
double integral_about(double middle, const Integrand& integrand) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      integrand, middle - kReach, middle + kReach, kDepth, kPrecision);
}

void refuse_no_choice(std::size_t alternatives) {
  if (alternatives < 2) {
    throw std::invalid_argument("alternatives is " + std::to_string(alternatives) +
                                "; a choice needs at least two");
  }
}

}  // namespace

double ForcedChoice::share(double dprime) const {
  refuse_no_choice(alternatives);
  const boost::math::normal normal;
  const auto others = static_cast<double>(alternatives - 1);
  return integral_about(dprime, [&](double x) {
    return boost::math::pdf(normal, x - dprime) * std::pow(boost::math::cdf(normal, x), others);
  });
}

double ForcedChoice::slope(double dprime) const {
  refuse_no_choice(alternatives);
  const boost::math::normal normal;
  const auto others = static_cast<double>(alternatives - 1);
  return integral_about(dprime, [&](double x) {
    return (x - dprime) * boost::math::pdf(normal, x - dprime) *
           std::pow(boost::math::cdf(normal, x), others);
  });
}

double ForcedChoice::dprime(double asked) const {
  refuse_no_choice(alternatives);
  if (!(asked >= 0.0 && asked <= 1.0)) {
    throw std::invalid_argument("the proportion correct is " + number_text(asked) +
                                "; it must lie between 0 and 1");
  }
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr double kFurthest = 15.0;  // beyond it a share is 0 or 1 to all digits
  const auto error = [&](double d) { return share(d) - asked; };
  const double low = error(-kFurthest);
  const double high = error(kFurthest);
  if (asked == 0.0 || low >= 0.0) {
    return -kInfinite;
  }
  if (asked == 1.0 || high <= 0.0) {
    return kInfinite;
  }
  // At chance d′ is 0, and the root is that of the quadrature's rounding.
  constexpr double kRounding = 1e-14;
  if (std::abs(asked - 1.0 / static_cast<double>(alternatives)) < kRounding) return 0.0;
  std::uintmax_t iterations = 200;
  const auto [below, above] =
      boost::math::tools::toms748_solve(error, -kFurthest, kFurthest, low, high,
                                        boost::math::tools::eps_tolerance<double>(50), iterations);
  return below + 0.5 * (above - below);
}

}  // namespace asperity
