// By chance ½ both tails are equal: the test rejects up to some count and from its mirror image on.

#include "analysis/choices/decisive_choices.h"

#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/proportion.h"

namespace asperity {
namespace {

void refuse_improbable(const char* name, double value) {
  if (!(value > 0.0 && value < 1.0)) {
    throw std::invalid_argument(std::string(name) + " is " + number_text(value) +
                                "; it must lie between 0 and 1");
  }
}

double power_of(std::uint64_t n, const DecisivePlan& plan) {
  // The rejecting counts below n/2 are 0 … rejecting − 1.
  std::uint64_t rejecting = 0;
  std::uint64_t beyond = n / 2 + 1;
  while (rejecting < beyond) {
    const std::uint64_t middle = (rejecting + beyond) / 2;
    const bool rejects =
        2 * middle < n && 2.0 * binomial_lower_tail({middle, n}, 0.5) <= plan.error;
    (rejects ? rejecting : beyond) = rejects ? middle + 1 : middle;
  }
  if (rejecting == 0) return 0.0;
  return binomial_lower_tail({rejecting - 1, n}, plan.preference) +
         binomial_upper_tail({n - rejecting + 1, n}, plan.preference);
}

}  // namespace

std::optional<std::size_t> decisive_choices(const DecisivePlan& plan) {
  refuse_improbable("preference", plan.preference);
  refuse_improbable("error", plan.error);
  refuse_improbable("power", plan.power);
  constexpr std::size_t kMost = 10'000;
  constexpr std::size_t kInARow = 7;
  std::size_t enough = 0;
  for (std::size_t n = plan.least; n < kMost + kInARow; ++n) {
    enough = power_of(n, plan) >= plan.power ? enough + 1 : 0;
    if (enough == kInARow) return n + 1 - kInARow;
  }
  return std::nullopt;
}

}  // namespace asperity
