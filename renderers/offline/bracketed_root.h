// Declares a root search in an interval with a change of sign.

#pragma once

#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

namespace asperity {

/// The two ends of an interval, or a function's values there.
struct Bracket {
  double low = 0.0;
  double high = 0.0;
};

/// The root of f in the bracket, accurate to `bits` bits; `values` are f(low) and f(high), which must differ in sign
/// unless one of them is zero.
template <class F>
double root_of(F f, const Bracket& bracket, const Bracket& values, int bits) {
  constexpr std::uintmax_t kIterations = 200;
  if (values.low == 0.0) return bracket.low;
  if (values.high == 0.0) return bracket.high;
  std::uintmax_t iterations = kIterations;
  const auto [low, high] = boost::math::tools::toms748_solve(
      f, bracket.low, bracket.high, values.low, values.high,
      boost::math::tools::eps_tolerance<double>(bits), iterations);
  return std::abs(f(low)) < std::abs(f(high)) ? low : high;
}

}  // namespace asperity
